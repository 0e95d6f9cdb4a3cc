// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/gaussian_map.h"

#include <utility>

namespace quoin {

GaussianMap gaussian_map(const Polytope& p, const Context& context) {
  return gaussian_map(map_arcs(p), context);
}

/// An arc turns about its edge: that tells it also where it is half a turn long. That of a segment has no ends.
GaussianMap gaussian_map(const MapArcs& arcs, const Context& context) {
  GaussianMap map;
  map.arcs = arcs.arcs;
  GeodesicFamily family;
  PieceList<GeodesicFamily> list;
  for (std::size_t i = 0; i < arcs.arcs.size(); ++i) {
    if (i % 256 == 0) context.poll();
    const MapArc& arc = arcs.arcs[i];
    if (arc.source == PolytopeShape::none) {
      family.add_great_circle(list, arcs.edges[i]);
    } else {
      family.add_arc(list, arcs.normals[arc.source], arcs.normals[arc.target], arcs.edges[i]);
    }
  }
  map.arrangement = arrange(std::move(family), std::move(list), context);
  const GeodesicArrangement& a = map.arrangement;
  map.vertex_of_face.assign(a.face_count(), 0);
  for (std::uint32_t e = 0; e < a.edge_count(); ++e) {
    const dcel::EdgeId edge(std::size_t{e});
    const CurveUse use = a.curves(edge)[0];
    const MapArc& arc = map.arcs[use.curve().index()];
    const dcel::HalfedgeId along(edge, use.is_reversed());
    map.vertex_of_face[a.cells().face(along).index()] = arc.head;
    map.vertex_of_face[a.cells().face(along.twin()).index()] = arc.tail;
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
