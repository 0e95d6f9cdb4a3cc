// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/linear/linear_polygon_set.h"

#include "quoin/arrangement/arrangement_impl.h"
#include "quoin/arrangement/sets/overlay_impl.h"
#include "quoin/arrangement/sets/polygon_rings_impl.h"
#include "quoin/arrangement/sets/polygon_set_combine_impl.h"
#include "quoin/arrangement/sets/ring_problem_impl.h"

namespace quoin {

template class PolygonSet<LinearFamily>;
template class Overlay<LinearFamily>;
template Superposition<LinearFamily> superpose(std::span<const LinearArrangement* const>, const Context&);
template Overlay<LinearFamily> overlay(std::span<const LinearArrangement* const>, const Context&);
template void visit_cells(const Overlay<LinearFamily>&, OverlayVisitor<LinearFamily>&);
template PolygonSet<LinearFamily> combine(std::span<const PolygonSet<LinearFamily>* const>, SetOperation, Regularity,
                                          const Context&);
template PolygonSet<LinearFamily> combine_rings(LinearFamily, const PieceList<LinearFamily>&,
                                                std::span<const std::uint32_t>, std::uint32_t, FillRule, SetOperation,
                                                const Context&);
template PolygonSet<LinearFamily> combine_regions(const Arrangement<LinearFamily>&, const RegionGroups&, SetOperation);
template std::optional<RingProblem> find_ring_problem(const Arrangement<LinearFamily>&, std::span<const std::uint32_t>,
                                                      const std::vector<bool>&);
template std::vector<PolygonWithHoles> polygons_of(const PolygonSet<LinearFamily>&);

/// Trapezoids under the edges between members and others: above an edge counts negative, below positive.
Rational area(const LinearPolygonSet& set) {
  if (set.is_unbounded()) throw InputError("an unbounded set has no area");
  const LinearArrangement& arrangement = set.arrangement();
  std::vector<RationalPoint2> points;
  for (std::size_t v = 0; v < arrangement.vertex_count(); ++v) {
    points.push_back(arrangement.cells().is_real(dcel::VertexId(v))
                         ? arrangement.family().exact(arrangement.point(dcel::VertexId(v)))
                         : RationalPoint2{});
  }
  Rational twice;
  for (std::size_t e = 0; e < arrangement.edge_count(); ++e) {
    const dcel::EdgeId id(e);
    if (!arrangement.cells().is_real(id)) continue;
    const bool above = set.contains(arrangement.cells().face(dcel::HalfedgeId(id, false)));
    const bool below = set.contains(arrangement.cells().face(dcel::HalfedgeId(id, true)));
    if (above == below) continue;
    const RationalPoint2& a = points[arrangement.left(id).index()];
    const RationalPoint2& b = points[arrangement.right(id).index()];
    const Rational trapezoid = (b.x - a.x) * (a.y + b.y);
    twice += below ? trapezoid : -trapezoid;
  }
  return twice / Rational(2);
}

}  // namespace quoin
