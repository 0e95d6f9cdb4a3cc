// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace quoin {

/// Into how many regions points are divided, each with at least so many points of a round; late ones, from a quarter of
/// that on. More threads than regions are of no use; more regions make more points late.
struct InsertionSplit {
  std::size_t regions = 2;
  std::size_t least_points = 16384;

  /// In space. By the number of points alone, so that results do not depend on threads.
  static InsertionSplit of(std::size_t count) {
    InsertionSplit split;
    if (count >= 4'000'000) split.regions = 4;
    return split;
  }
  /// In the plane, where regions have shorter borders for as many points.
  static InsertionSplit in_plane(std::size_t count) {
    InsertionSplit split{.regions = 2, .least_points = 4096};
    if (count >= 2'000'000) split.regions = 4;
    if (count >= 8'000'000) split.regions = 8;
    return split;
  }
  /// One point after the other: the quickest on one thread, where the order of cells is not asked for.
  static InsertionSplit none() {
    InsertionSplit split;
    split.regions = 1;
    return split;
  }
};

}  // namespace quoin
