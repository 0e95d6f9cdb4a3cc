// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/map_arcs.h"

#include <algorithm>
#include <array>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/kernel/closest_point.h"

namespace quoin {

namespace {

using Vector = std::array<Rational, 3>;

Vector vector_of(const EdgeVector& v) {
  RationalPoint3 p = exact_vector(v);
  return {std::move(p.x), std::move(p.y), std::move(p.z)};
}

Vector vector_of(const RationalPoint3& from, const RationalPoint3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

/// A side of a facet, with its vertices in ascending order in front: the two of an edge are neighbours when sorted.
struct FacetSide {
  std::uint32_t low;
  std::uint32_t high;
  bool is_descending;
  std::uint32_t facet;

  friend auto operator<=>(const FacetSide&, const FacetSide&) = default;
};

std::vector<FacetSide> sides_of(const PolytopeSum& sum) {
  std::vector<FacetSide> sides;
  sides.reserve(sum.corners.size());
  for (std::size_t f = 0; f < sum.facet_count(); ++f) {
    const auto facet = sum.facet(f);
    for (std::size_t i = 0; i < facet.size(); ++i) {
      const std::uint32_t from = facet[i];
      const std::uint32_t to = facet[i + 1 < facet.size() ? i + 1 : 0];
      sides.push_back({std::min(from, to), std::max(from, to), from > to, static_cast<std::uint32_t>(f)});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace

MapArcs map_arcs(const Polytope& p) {
  MapArcs map;
  map.vertex_count = p.vertex_count();
  map.normals.reserve(p.facet_count());
  for (std::uint32_t f = 0; f < p.facet_count(); ++f) {
    const std::uint32_t h = p.first_halfedge(f);
    map.normals.emplace_back(closest::cross(vector_of(p.edge(h)), vector_of(p.edge(p.halfedges()[h].next))));
  }
  for (std::uint32_t h = 0; h < p.halfedges().size(); ++h) {
    const Polytope::Halfedge& halfedge = p.halfedges()[h];
    if (halfedge.twin < h) continue;
    map.arcs.push_back({halfedge.facet, p.halfedges()[halfedge.twin].facet, halfedge.head, halfedge.tail});
    map.edges.emplace_back(vector_of(p.edge(h)));
  }
  return map;
}

MapArcs map_arcs(const PolytopeSum& sum, const Polytope& p, const Polytope& q) {
  if (sum.dimension < 3) throw InputError("the sum is flat: only of solids is the map made");
  const std::vector<RationalPoint3> points = exact_vertices(sum, p, q);
  MapArcs map;
  map.vertex_count = points.size();
  map.normals.reserve(sum.facet_count());
  for (std::size_t f = 0; f < sum.facet_count(); ++f) {
    const auto facet = sum.facet(f);
    map.normals.emplace_back(
        closest::cross(vector_of(points[facet[0]], points[facet[1]]), vector_of(points[facet[1]], points[facet[2]])));
  }
  const std::vector<FacetSide> sides = sides_of(sum);
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    const FacetSide& up = sides[i];
    map.arcs.push_back({up.facet, sides[i + 1].facet, up.high, up.low});
    map.edges.emplace_back(vector_of(points[up.low], points[up.high]));
  }
  return map;
}

}  // namespace quoin
