// SPDX-License-Identifier: Apache-2.0
// Sums and erosions of solids with polytopes that may be flat.
#include <vector>

#include "quoin/polytope/complement_in_box.h"
#include "quoin/polytope/convex_boundary.h"
#include "quoin/polytope/convex_pieces.h"
#include "quoin/polytope/decomposition.h"
#include "quoin/polytope/half_space.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/solid_sum.h"

namespace quoin {

namespace {

ExactBox bounds_of(const Polytope& polytope) {
  ExactBox box{polytope.exact_vertex(0), polytope.exact_vertex(0)};
  for (std::uint32_t v = 0; v < polytope.vertex_count(); ++v) box.extend(polytope.exact_vertex(v));
  return box;
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

/// The sum of what a leaves of a box and b reflected is all but the places where b fits, and what lies beyond: the
/// bounds of a, moved by a vertex of b, hold the former and none of the latter.
Solid erosion(const Solid& a, const Polytope& b, const Context& context) {
  if (a.is_empty()) return {};
  const Solid rest = complement_in_box(a, bounds_of(b), context);
  const Solid blocked = minkowski_sum(rest, reflected(b), context);
  const ExactBox places = exact_bounds(a.boundary()).moved(b.exact_vertex(0) * Rational(-1));
  return subtract(solid_box(places, context), {&blocked, 1}, context);
}

}  // namespace quoin
