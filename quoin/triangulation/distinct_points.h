// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "quoin/base/context.h"

namespace quoin::detail {

/// Whether there are more than `few` distinct ones among `point(0)` ... `point(count - 1)`; looks no further than to
/// the first beyond. O(few count), polls.
template <std::size_t few, class Point, class PointAt>
bool has_more_distinct_points(std::size_t count, const PointAt& point, const Context& context) {
  if (count <= few) return false;
  std::array<Point, few> distinct;
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 1024 == 1023) context.poll();
    const Point& p = point(i);
    std::size_t k = 0;
    while (k < found && !(distinct[k] == p)) ++k;
    if (k < found) continue;
    if (found == few) return true;
    distinct[found++] = p;
  }
  return false;
}

}  // namespace quoin::detail
