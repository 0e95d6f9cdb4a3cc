// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/sign.h"
#include "quoin/flow/delone_faces.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// Sign of (q - p0) . (q - p1): positive outside the sphere over the edge. Exact.
Sign side_of_diametral_sphere(const Point3& p0, const Point3& p1, const Point3& q);

/// Sign of the power of q to the sphere that has the circle through three points as a great circle: positive outside.
/// Exact; the three must not be collinear. A comparison with a derived bound, then rationals.
Sign side_of_great_sphere(const std::array<Point3, 3>& circle, const Point3& q);

/// Where centres are relative to the faces' own boundaries. All questions about the flow that do not follow an orbit
/// are answered by these signs.
class FaceSigns {
 public:
  /// O(n) exact signs. @throws Cancelled
  FaceSigns(const DeloneFaces& faces, std::span<const Point3> points, const Context& context);

  /// Of the circumcentre of polygon f against its side at this place: positive on the side of the polygon.
  Sign at_side(const DeloneFaces& faces, std::uint32_t f, std::size_t side) const {
    return at_side_[faces.first_corner(f) + side];
  }
  /// Of the circumcentre of the cell on one side (0, 1) of polygon f against f: positive on the side of the cell.
  /// Positive, too, where there is no cell.
  Sign at_polygon(std::uint32_t f, std::size_t side) const { return at_polygon_[f][side]; }

 private:
  std::vector<Sign> at_side_;
  std::vector<std::array<Sign, 2>> at_polygon_;
};

}  // namespace quoin
