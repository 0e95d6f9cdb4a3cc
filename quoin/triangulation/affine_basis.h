// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// As many of the points as are affinely independent, the first ones, in the order given.
struct AffineBasis {
  std::vector<std::uint32_t> vertices;  ///< one more than the dimension
  unsigned normal_axis = 2;             ///< of three points: along which their plane can be projected
};

/// Of distinct points, at least one. Exact; O(n). @throws Cancelled
AffineBasis affine_basis(std::span<const Point3> points, const Context& context);

/// An axis along which the triangle has an area when it is projected; 3 if the points lie on a line. Exact.
unsigned normal_axis(const Point3& a, const Point3& b, const Point3& c);

/// Off the plane of a basis of three points, at about the distance of the size of the others.
Point3 point_off_plane(std::span<const Point3> points, const AffineBasis& basis);

}  // namespace quoin
