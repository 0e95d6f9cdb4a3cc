// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/gaussian_map.h"

#include <utility>

#include "quoin/kernel/closest_point.h"

namespace quoin {

namespace {

using Vector = std::array<Rational, 3>;

Vector vector_of(const EdgeVector& v) {
  return {Rational(v.to.x) - Rational(v.from.x), Rational(v.to.y) - Rational(v.from.y),
          Rational(v.to.z) - Rational(v.from.z)};
}

std::vector<SphereDirection> normals_of(const Polytope& p) {
  std::vector<SphereDirection> normals;
  normals.reserve(p.facet_count());
  for (std::uint32_t f = 0; f < p.facet_count(); ++f) {
    const std::uint32_t h = p.first_halfedge(f);
    normals.emplace_back(closest::cross(vector_of(p.edge(h)), vector_of(p.edge(p.halfedges()[h].next))));
  }
  return normals;
}

}  // namespace

/// An arc turns about its edge: that tells it also where it is half a turn long.
GaussianMap gaussian_map(const Polytope& p, const Context& context) {
  GaussianMap map;
  const std::vector<SphereDirection> normals = normals_of(p);
  GeodesicFamily family;
  PieceList<GeodesicFamily> list;
  for (std::uint32_t h = 0; h < p.halfedges().size(); ++h) {
    const Polytope::Halfedge& halfedge = p.halfedges()[h];
    if (halfedge.twin < h) continue;
    family.add_arc(list, normals[halfedge.facet], normals[p.halfedges()[halfedge.twin].facet],
                   SphereDirection(vector_of(p.edge(h))));
    map.arcs.push_back(h);
  }
  map.arrangement = arrange(std::move(family), std::move(list), context);
  const GeodesicArrangement& a = map.arrangement;
  map.vertex_of_face.assign(a.face_count(), 0);
  for (std::uint32_t e = 0; e < a.edge_count(); ++e) {
    const dcel::EdgeId edge(std::size_t{e});
    const CurveUse use = a.curves(edge)[0];
    const Polytope::Halfedge& halfedge = p.halfedges()[map.arcs[use.curve().index()]];
    const dcel::HalfedgeId along(edge, use.is_reversed());
    map.vertex_of_face[a.cells().face(along).index()] = halfedge.head;
    map.vertex_of_face[a.cells().face(along.twin()).index()] = halfedge.tail;
  }
  return map;
}

/// What leaves a vertex of the map counterclockwise has on its left what follows counterclockwise around the facet.
std::vector<std::vector<std::uint32_t>> facets_of_map(const GaussianMap& map) {
  const dcel::Dcel& cells = map.arrangement.cells();
  std::vector<std::vector<std::uint32_t>> facets;
  for (std::size_t v = 0; v < cells.vertices.size(); ++v) {
    std::vector<std::uint32_t> facet;
    const dcel::HalfedgeId first = cells.vertices[v].out;
    dcel::HalfedgeId out = first;
    do {
      facet.push_back(map.vertex_of_face[cells.face(out).index()]);
      out = cells.previous(out).twin();
    } while (out != first);
    if (facet.size() > 2) facets.push_back(std::move(facet));
  }
  return facets;
}

}  // namespace quoin
