// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/cubical_links.h"

#include "quoin/base/error.h"

namespace quoin::cube {

namespace {

using dcel::Dcel;
using dcel::FaceId;
using dcel::HalfedgeId;
using dcel::VertexId;
using Place = CubicalMap::Place;
using Square = CubicalMap::Square;
using Location = CubicalMap::Location;

constexpr std::uint32_t none = CubicalMap::none;

bool is_outside(const Dcel& cells, HalfedgeId h) {
  return cells[cells.face(h)].is_unbounded;
}

/// The side that leaves a vertex of the border with the square on its left.
HalfedgeId first_side(const Dcel& cells, VertexId v) {
  HalfedgeId h = cells[v].out;
  while (!is_outside(cells, h.twin())) h = cells.clockwise(h);
  return h;
}

/// The side that leaves a vertex of the border with the square on its right.
HalfedgeId last_side(const Dcel& cells, VertexId v) {
  return cells.clockwise(first_side(cells, v));
}

/// From a corner the border goes on with the square on its left; on the next square clockwise the same points follow
/// with that one on its right.
void link_side(CubicalMap& map, const Corner& corner) {
  const Corner other = clockwise(corner);
  const auto at = [&](const Corner& c) { return map.squares[c.square].corners[c.corner]; };
  const Dcel& cells = map.squares[corner.square].arrangement.cells();
  const Dcel& other_cells = map.squares[other.square].arrangement.cells();
  VertexId v = at(corner);
  VertexId w = at(other);
  while (true) {
    v = cells.target(first_side(cells, v));
    w = other_cells.target(last_side(other_cells, w));
    CubicalMap::Vertex& a = map.squares[corner.square].vertices[v.index()];
    CubicalMap::Vertex& b = map.squares[other.square].vertices[w.index()];
    if (a.location != b.location) throw InternalError("the sides of two squares of a cubical map do not fit");
    if (a.location == Location::corner) return;
    a.next = {other.square, w};
    b.next = {corner.square, v};
  }
}

void link_corner(CubicalMap& map, const Corner& corner) {
  const Corner next = clockwise(corner);
  const VertexId v = map.squares[corner.square].corners[corner.corner];
  map.squares[corner.square].vertices[v.index()].next = {next.square, map.squares[next.square].corners[next.corner]};
}

/// A normal at the border may have all its arcs on other squares.
void spread_facets(CubicalMap& map, const Place& from) {
  const std::uint32_t facet = map[from].facet;
  if (facet == none) return;
  for (Place p = map[from].next; !(p == from); p = map[p].next) {
    map.squares[p.square].vertices[p.vertex.index()].facet = facet;
  }
}

/// The face across the side that begins at a corner.
std::uint32_t label_across(const CubicalMap& map, const Corner& corner) {
  const Corner other = clockwise(corner);
  const Square& square = map.squares[other.square];
  const Dcel& cells = square.arrangement.cells();
  return square.vertex_of_face[cells.face(last_side(cells, square.corners[other.corner]).twin()).index()];
}

bool is_unlabelled(const Square& square, FaceId f) {
  const Dcel& cells = square.arrangement.cells();
  return cells.is_real(f) && !cells[f].is_unbounded && square.vertex_of_face[f.index()] == none;
}

/// Whether all faces of a square have labels after this.
bool label_from_neighbours(CubicalMap& map, std::uint8_t number) {
  Square& square = map.squares[number];
  for (std::size_t i = 0; i < square.vertex_of_face.size(); ++i) {
    if (!is_unlabelled(square, FaceId(i))) continue;
    for (std::uint8_t c = 0; c < corner_count && square.vertex_of_face[i] == none; ++c) {
      square.vertex_of_face[i] = label_across(map, {number, c});
    }
    if (square.vertex_of_face[i] == none) return false;
  }
  return true;
}

}  // namespace

void link_squares(CubicalMap& map) {
  for (std::uint8_t s = 0; s < square_count; ++s) {
    for (std::size_t v = 0; v < map.squares[s].vertices.size(); ++v) {
      map.squares[s].vertices[v].next = {s, VertexId(v)};
    }
  }
  for (std::uint8_t s = 0; s < square_count; ++s) {
    for (std::uint8_t c = 0; c < corner_count; ++c) {
      link_corner(map, {s, c});
      link_side(map, {s, c});
    }
  }
  for (std::uint32_t s = 0; s < square_count; ++s) {
    for (std::size_t v = 0; v < map.squares[s].vertices.size(); ++v) spread_facets(map, {s, VertexId(v)});
  }
}

void label_with_the_only_vertex(CubicalMap& map) {
  for (Square& square : map.squares) {
    for (std::size_t f = 0; f < square.vertex_of_face.size(); ++f) {
      if (is_unlabelled(square, FaceId(f))) square.vertex_of_face[f] = 0;
    }
  }
}

void spread_labels(CubicalMap& map) {
  bool is_done = false;
  for (std::size_t round = 0; round < square_count && !is_done; ++round) {
    is_done = true;
    for (std::uint8_t s = 0; s < square_count; ++s) is_done = label_from_neighbours(map, s) && is_done;
  }
  if (!is_done) throw InternalError("a face of a cubical map has no neighbour that tells whose directions it holds");
}

std::vector<HalfedgeId> fan(const Square& square, VertexId v) {
  const Dcel& cells = square.arrangement.cells();
  const bool is_inside = square.vertices[v.index()].location == Location::interior;
  const HalfedgeId first = is_inside ? cells[v].out : first_side(cells, v);
  std::vector<HalfedgeId> out;
  HalfedgeId h = first;
  do {
    out.push_back(h);
    h = cells.counterclockwise(h);
  } while (h != first && !is_outside(cells, h));
  return out;
}

}  // namespace quoin::cube

namespace quoin {

namespace {

using Place = CubicalMap::Place;

/// Counterclockwise from place to place: against the links.
Place previous(const CubicalMap& map, const Place& place) {
  Place p = place;
  while (!(map[p].next == place)) p = map[p].next;
  return p;
}

bool is_first(const CubicalMap& map, const Place& place) {
  for (Place p = map[place].next; !(p == place); p = map[p].next) {
    if (p.square < place.square) return false;
  }
  return true;
}

/// The labels around a point of the cube; a side of a square may cut the directions of a vertex in two.
std::vector<std::uint32_t> ring_at(const CubicalMap& map, const Place& place) {
  std::vector<std::uint32_t> ring;
  Place p = place;
  do {
    const CubicalMap::Square& square = map.squares[p.square];
    for (const dcel::HalfedgeId h : cube::fan(square, p.vertex)) {
      const std::uint32_t label = square.vertex_of_face[square.arrangement.cells().face(h).index()];
      if (ring.empty() || ring.back() != label) ring.push_back(label);
    }
    p = previous(map, p);
  } while (!(p == place));
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> facets_of_map(const CubicalMap& map) {
  std::vector<std::vector<std::uint32_t>> facets;
  for (std::uint32_t s = 0; s < cube::square_count; ++s) {
    for (std::size_t v = 0; v < map.squares[s].vertices.size(); ++v) {
      const Place place{s, dcel::VertexId(v)};
      if (map[place].is_real() && is_first(map, place)) facets.push_back(ring_at(map, place));
    }
  }
  return facets;
}

}  // namespace quoin
