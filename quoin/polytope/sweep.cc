// SPDX-License-Identifier: Apache-2.0
// Sums and erosions of solids with polytopes that may be flat.
#include <algorithm>
#include <array>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/polytope/convex_boundary.h"
#include "quoin/polytope/convex_pieces.h"
#include "quoin/polytope/decomposition.h"
#include "quoin/polytope/half_space.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/solid_sum.h"

namespace quoin {

namespace {

/// The box about a solid and what a polytope reaches from it to all sides.
std::array<RationalPoint3, 2> box_around(const Solid& solid, const Polytope& polytope) {
  const Brep& boundary = solid.boundary();
  std::array<RationalPoint3, 2> box{boundary.points.exact(boundary.loop_vertices[0]), {}};
  box[1] = box[0];
  const auto extend = [](std::array<RationalPoint3, 2>& of, const RationalPoint3& p) {
    of[0] = {std::min(of[0].x, p.x), std::min(of[0].y, p.y), std::min(of[0].z, p.z)};
    of[1] = {std::max(of[1].x, p.x), std::max(of[1].y, p.y), std::max(of[1].z, p.z)};
  };
  for (const PointId v : boundary.loop_vertices) extend(box, boundary.points.exact(v));
  std::array<RationalPoint3, 2> reach{polytope.exact_vertex(0), polytope.exact_vertex(0)};
  for (std::uint32_t v = 0; v < polytope.vertex_count(); ++v) extend(reach, polytope.exact_vertex(v));
  const RationalPoint3 one{Rational(1), Rational(1), Rational(1)};
  const RationalPoint3 size = reach[1] - reach[0] + one;
  return {box[0] - size, box[1] + size};
}

}  // namespace

Solid minkowski_sum(const Solid& a, const Polytope& b, const Context& context) {
  if (a.is_empty()) return {};
  std::vector<Solid> sums;
  for (const Solid& piece : convex_decomposition(a, context).pieces) {
    const Polytope p = hull_of_boundary(piece.boundary(), context);
    const PolytopeSum sum = minkowski_sum(p, b, context);
    sums.push_back(Solid::from_boundary(convex_boundary(exact_vertices(sum, p, b), sum.corners, sum.facet_begin, "sum"),
                                        "sum", context));
  }
  return unite(sums, context);
}

/// In a box that holds everything b reaches from a, the sum of what a leaves of it and b reflected is all but the
/// places where b fits, and the rim of the box: that is cut off with the bounds of a moved by a vertex of b.
Solid erosion(const Solid& a, const Polytope& b, const Context& context) {
  if (a.is_empty()) return {};
  if (a.boundary().is_unbounded) throw InputError("the first operand is unbounded");
  const std::array<RationalPoint3, 2> box = box_around(a, b);
  const SectionPlane top{{Rational(0), Rational(0), Rational(1)}, box[1].z};
  const Solid all = half_space_in_box(box, top, context);
  const Solid blocked = minkowski_sum(subtract(all, {&a, 1}, context), reflected(b), context);
  const RationalPoint3 by = b.exact_vertex(0);
  const std::array<RationalPoint3, 2> moved{box[0] - by, box[1] - by};
  const SectionPlane moved_top{top.normal, moved[1].z};
  return subtract(half_space_in_box(moved, moved_top, context), {&blocked, 1}, context);
}

}  // namespace quoin
