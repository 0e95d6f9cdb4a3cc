// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/minkowski_sum.h"

#include <numeric>
#include <utility>

#include "quoin/polytope/flat_sums.h"
#include "quoin/polytope/overlay_sum.h"

namespace quoin {

namespace {

/// The shape of a sum of two; its edges are those of the summands, which must live as long.
class SumShape : public PolytopeShape {
 public:
  SumShape(const PolytopeSum& sum, const PolytopeShape& p, const PolytopeShape& q) {
    link(sum.dimension, sum.vertices.size(), {sum.corners, sum.facet_begin});
    edges_.reserve(halfedges().size());
    for (const Halfedge& h : halfedges()) {
      const auto& tail = sum.vertices[h.tail];
      const auto& head = sum.vertices[h.head];
      edges_.push_back(tail[0] != head[0] ? edge_between(p, tail[0], head[0]) : edge_between(q, tail[1], head[1]));
    }
    set_vectors();
  }

 private:
  /// An edge of the sum is the sum of two parallel edges, or of an edge and a vertex.
  static EdgeVector edge_between(const PolytopeShape& shape, std::uint32_t tail, std::uint32_t head) {
    std::uint32_t h = shape.first_out(tail);
    while (shape.halfedges()[h].head != head) ++h;
    return shape.edge(h);
  }
};

void take_rings(FacetRings& to, FacetRings&& from) {
  to = std::move(from);
}

}  // namespace

PolytopeSum minkowski_sum(const PolytopeShape& p, const PolytopeShape& q, const Context& context) {
  if (p.dimension() < 2 || q.dimension() < 2 || (p.dimension() < 3 && q.dimension() < 3)) {
    return flat_sum(p, q, context);
  }
  return overlay_sum(p, q, context);
}

std::vector<RationalPoint3> exact_vertices(const PolytopeSum& sum, const Polytope& p, const Polytope& q) {
  std::vector<RationalPoint3> result;
  result.reserve(sum.vertices.size());
  for (const auto& [a, b] : sum.vertices) result.push_back(p.exact_vertex(a) + q.exact_vertex(b));
  return result;
}

PolytopeSumOfMany minkowski_sum(std::span<const Polytope> summands, const Context& context) {
  PolytopeSumOfMany result;
  result.summand_count = summands.size();
  if (summands.empty()) return result;
  PolytopeShape shape = summands[0];
  // Of as many indices as there were summands, for each vertex of the shape.
  std::vector<std::uint32_t> tuples(shape.vertex_count());
  std::iota(tuples.begin(), tuples.end(), 0U);
  if (summands.size() == 1) {
    const Polytope origin = Polytope::hull_of(std::vector<Point3>{{0, 0, 0}}, context);
    PolytopeSum same = minkowski_sum(shape, origin, context);
    take_rings(result, std::move(same));
  }
  for (std::size_t i = 1; i < summands.size(); ++i) {
    PolytopeSum sum = minkowski_sum(shape, summands[i], context);
    std::vector<std::uint32_t> longer;
    longer.reserve(sum.vertices.size() * (i + 1));
    for (const auto& [v, w] : sum.vertices) {
      longer.insert(longer.end(), tuples.begin() + static_cast<std::ptrdiff_t>(v * i),
                    tuples.begin() + static_cast<std::ptrdiff_t>((v + 1) * i));
      longer.push_back(w);
    }
    tuples = std::move(longer);
    if (i + 1 < summands.size()) shape = SumShape(sum, shape, summands[i]);
    take_rings(result, std::move(sum));
  }
  result.vertices = std::move(tuples);
  return result;
}

std::vector<RationalPoint3> exact_vertices(const PolytopeSumOfMany& sum, std::span<const Polytope> summands) {
  std::vector<RationalPoint3> result;
  result.reserve(sum.vertex_count());
  for (std::size_t v = 0; v < sum.vertex_count(); ++v) {
    RationalPoint3 p{0, 0, 0};
    for (std::size_t i = 0; i < summands.size(); ++i) p = p + summands[i].exact_vertex(sum.vertex(v)[i]);
    result.push_back(std::move(p));
  }
  return result;
}

}  // namespace quoin
