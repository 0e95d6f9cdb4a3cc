// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "quoin/kernel/transformation.h"

namespace quoin::io {

/// How far coordinates moved when they were rounded.
struct RoundingCount {
  std::size_t coordinates = 0;
  double largest = 0;  ///< rounded up
};

/// Images of points under an affine map, each coordinate exact and then rounded once, to the nearest double, ties to
/// even.
///
/// Where the entries are sums of a few doubles and nothing leaves their range, expansions decide; rationals elsewhere.
class Placement {
 public:
  /// The determinant must not be zero.
  explicit Placement(const Transformation& map);

  bool is_mirror() const { return is_mirror_; }
  /// Infinite where a coordinate is beyond the largest double. Counts what is rounded. O(1) but for rationals.
  Point3 image(const Point3& p, RoundingCount& rounding) const;

 private:
  /// `factor` times the coordinate of an axis; of axis 3, which stands for 1, by itself.
  struct Term {
    std::size_t axis = 0;
    double factor = 0;
  };
  bool fast_coordinate(std::size_t row, const Point3& p, double& value, RoundingCount& rounding) const;
  double exact_coordinate(std::size_t row, const Point3& p, RoundingCount& rounding) const;

  Transformation map_;
  bool is_identity_;
  bool is_mirror_;
  std::array<std::vector<Term>, 3> terms_;  // of each row
  std::array<bool, 3> has_terms_{};         // whether they are the whole row
};

}  // namespace quoin::io
