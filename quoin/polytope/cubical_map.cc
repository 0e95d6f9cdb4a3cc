// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/cubical_map.h"

#include <optional>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/polytope/cubical_clipping.h"
#include "quoin/polytope/cubical_links.h"

namespace quoin {

namespace {

using dcel::EdgeId;
using dcel::FaceId;
using dcel::HalfedgeId;
using dcel::VertexId;
using Location = CubicalMap::Location;
using Square = CubicalMap::Square;

constexpr std::uint32_t none = CubicalMap::none;
constexpr std::uint32_t side_count = 4;

/// What a curve of a square is a part of; the first four are its sides.
struct Origin {
  std::uint32_t arc;
  bool has_source;
  bool has_target;
};

void add_sides(LinearFamily& family, PieceList<LinearFamily>& list) {
  constexpr std::array<Point2, side_count> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (std::size_t i = 0; i < side_count; ++i) family.add_segment(list, corners[i], corners[(i + 1) % side_count]);
}

/// Corners of a square ascend as its vertices do: by X, then by Y.
void find_locations(Square& square) {
  const LinearArrangement& a = square.arrangement;
  square.vertices.resize(a.vertex_count());
  std::size_t corners = 0;
  for (std::size_t i = 0; i < a.vertex_count(); ++i) {
    const VertexId v(i);
    if (!a.cells().is_real(v)) continue;
    const RationalPoint2 at = a.family().exact(a.point(v));
    const bool has_x = abs(at.x) == Rational(1);
    const bool has_y = abs(at.y) == Rational(1);
    square.vertices[i].location = has_x && has_y   ? Location::corner
                                  : has_x || has_y ? Location::side
                                                   : Location::interior;
    if (has_x && has_y) square.corners[corners++] = v;
  }
}

/// What lies along an arc: the edge is real, its ends may be normals, its sides are directions of vertices.
void label_edge(Square& square, EdgeId edge, const CurveUse& use, const Origin& origin, const MapArc& arc) {
  const dcel::Dcel& cells = square.arrangement.cells();
  const HalfedgeId along(edge, use.is_reversed());
  square.arc_of_edge[edge.index()] = origin.arc;
  if (origin.has_source) square.vertices[cells.origin(along).index()].facet = arc.source;
  if (origin.has_target) square.vertices[cells.target(along).index()].facet = arc.target;
  const auto label = [&](HalfedgeId h, std::uint32_t vertex) {
    const FaceId face = cells.face(h);
    if (!cells[face].is_unbounded) square.vertex_of_face[face.index()] = vertex;
  };
  label(along, arc.head);
  label(along.twin(), arc.tail);
}

void label_cells(Square& square, const std::vector<Origin>& origins, const MapArcs& map) {
  const LinearArrangement& a = square.arrangement;
  square.arc_of_edge.assign(a.edge_count(), none);
  square.vertex_of_face.assign(a.face_count(), none);
  for (std::size_t i = 0; i < a.edge_count(); ++i) {
    const EdgeId edge(i);
    if (!a.cells().is_real(edge)) continue;
    for (const CurveUse use : a.curves(edge)) {
      if (use.curve().index() < side_count) continue;
      const Origin& origin = origins[use.curve().index() - side_count];
      label_edge(square, edge, use, origin, map.arcs[origin.arc]);
    }
  }
}

Square make_square(std::size_t number, const MapArcs& map, const cube::Clipping& clipping, const Context& context) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  add_sides(family, list);
  std::vector<Origin> origins;
  for (std::size_t i = 0; i < map.arcs.size(); ++i) {
    if (i % 256 == 0) context.poll();
    const std::optional<cube::Part> part = clipping.on_square(i, number);
    if (!part) continue;
    family.add_segment(list, part->from, part->to);
    origins.push_back({static_cast<std::uint32_t>(i), part->has_source, part->has_target});
  }
  Square square;
  square.arrangement = arrange(std::move(family), std::move(list), context);
  find_locations(square);
  label_cells(square, origins, map);
  return square;
}

}  // namespace

CubicalMap cubical_map(const Polytope& p, const Context& context) {
  return cubical_map(map_arcs(p), context);
}

CubicalMap cubical_map(const MapArcs& arcs, const Context& context) {
  if (arcs.normals.empty() && !arcs.arcs.empty()) throw InputError("a segment has no map on the cube");
  CubicalMap map;
  map.arcs = arcs.arcs;
  const cube::Clipping clipping(arcs);
  for (std::size_t s = 0; s < cube::square_count; ++s) map.squares[s] = make_square(s, arcs, clipping, context);
  cube::link_squares(map);
  if (arcs.vertex_count == 1) cube::label_with_the_only_vertex(map);
  if (arcs.vertex_count > 1) cube::spread_labels(map);
  return map;
}

CubicalMap::Counts CubicalMap::counts(std::size_t square) const {
  const dcel::Counts counts = squares[square].arrangement.counts();
  return {counts.vertices, counts.edges, counts.faces};
}

CubicalMap::Counts CubicalMap::counts() const {
  Counts all;
  for (std::size_t s = 0; s < cube::square_count; ++s) {
    const Counts one = counts(s);
    all.vertices += one.vertices;
    all.edges += one.edges;
    all.faces += one.faces;
  }
  return all;
}

}  // namespace quoin
