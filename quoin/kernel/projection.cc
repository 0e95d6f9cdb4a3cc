// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/projection.h"

#include <array>
#include <cmath>
#include <utility>

#include "quoin/base/error.h"

namespace quoin {

unsigned projection_axis(const Constructions& points, PointId a, PointId b, PointId c) {
  const Point3& p = points.rounded(a);
  const Point3& q = points.rounded(b);
  const Point3& r = points.rounded(c);
  std::array<double, 3> size{};
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned u = (k + 1) % 3;
    const unsigned v = (k + 2) % 3;
    size[k] = std::fabs((q[u] - p[u]) * (r[v] - p[v]) - (q[v] - p[v]) * (r[u] - p[u]));
  }
  // The sizes only say what is tried first; where they are no numbers, any order serves.
  std::array<unsigned, 3> order{0, 1, 2};
  if (size[order[0]] < size[order[1]]) std::swap(order[0], order[1]);
  if (size[order[0]] < size[order[2]]) std::swap(order[0], order[2]);
  for (const unsigned axis : order) {
    if (points.turn(a, b, c, axis) != Sign::zero) return axis;
  }
  throw InternalError("three collinear points span no plane to project");
}

}  // namespace quoin
