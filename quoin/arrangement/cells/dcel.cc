// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/cells/dcel.h"

#include <string>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/error.h"

namespace quoin::dcel {

namespace {

void require(bool condition, const char* what, std::size_t index) {
  if (!condition) throw InternalError(std::string("subdivision: ") + what + ' ' + std::to_string(index));
}

/// Components of everything that is alive, fictitious cells too.
std::size_t count_components(const Dcel& dcel) {
  DisjointSets sets(dcel.vertices.size());
  for (std::size_t e = 0; e < dcel.edges.size(); ++e) {
    if (dcel.edges[e] == CellState::dead) continue;
    const HalfedgeId h(EdgeId(e), false);
    sets.unite(dcel.origin(h).value, dcel.target(h).value);
  }
  std::size_t components = 0;
  for (std::uint32_t v = 0; v < dcel.vertices.size(); ++v) {
    components += static_cast<std::size_t>(dcel.vertices[v].state != CellState::dead && sets.find(v) == v);
  }
  return components;
}

void check_halfedges(const Dcel& dcel) {
  for (std::size_t i = 0; i < dcel.halfedges.size(); ++i) {
    const HalfedgeId h(i);
    if (dcel.edges[h.edge().index()] == CellState::dead) continue;
    require(dcel.previous(dcel.next(h)) == h, "previous of next of halfedge", i);
    require(dcel.next(dcel.previous(h)) == h, "next of previous of halfedge", i);
    require(dcel.origin(dcel.next(h)) == dcel.target(h), "target of halfedge", i);
    require(dcel[h].boundary == dcel[dcel.next(h)].boundary, "boundary of halfedge", i);
    require(dcel[dcel.origin(h)].state != CellState::dead, "dead origin of halfedge", i);
    require(!dcel[dcel[h].boundary].halfedge.is_none(), "dead boundary of halfedge", i);
  }
}

void check_vertices(const Dcel& dcel) {
  for (std::size_t i = 0; i < dcel.vertices.size(); ++i) {
    const Vertex& vertex = dcel.vertices[i];
    if (vertex.state == CellState::dead || vertex.out.is_none()) continue;
    require(dcel.edges[vertex.out.edge().index()] != CellState::dead, "dead edge at vertex", i);
    require(dcel.origin(vertex.out) == VertexId(i), "outgoing halfedge of vertex", i);
  }
}

/// Every boundary and isolated vertex is in the list of its face, once. Returns the number of boundaries.
std::size_t check_faces(const Dcel& dcel) {
  std::size_t listed = 0;
  std::size_t isolated = 0;
  for (std::size_t i = 0; i < dcel.faces.size(); ++i) {
    if (dcel.faces[i].state == CellState::dead) continue;
    for (BoundaryId b = dcel.faces[i].first_boundary; !b.is_none(); b = dcel[b].next) {
      require(dcel[b].face == FaceId(i), "list of boundaries of face", i);
      require(!dcel[b].halfedge.is_none() && dcel[dcel[b].halfedge].boundary == b, "boundary of face", i);
      require(++listed <= dcel.boundaries.size(), "endless list of boundaries of face", i);
    }
    for (VertexId v = dcel.faces[i].first_isolated; !v.is_none(); v = dcel[v].next_isolated) {
      require(dcel[v].face == FaceId(i) && dcel.is_isolated(v), "list of isolated vertices of face", i);
      require(++isolated <= dcel.vertices.size(), "endless list of isolated vertices of face", i);
    }
  }
  std::size_t alive = 0;
  for (const Boundary& boundary : dcel.boundaries) alive += static_cast<std::size_t>(!boundary.halfedge.is_none());
  require(alive == listed, "boundaries that no face lists:", alive - listed);
  std::size_t alone = 0;
  for (const Vertex& vertex : dcel.vertices) {
    alone += static_cast<std::size_t>(vertex.state != CellState::dead && vertex.out.is_none());
  }
  require(alone == isolated, "isolated vertices that no face lists:", alone - isolated);
  return listed + isolated;
}

template <class List, class Alive>
std::size_t count_if_alive(const List& list, const Alive& alive) {
  std::size_t count = 0;
  for (const auto& cell : list) count += static_cast<std::size_t>(alive(cell));
  return count;
}

}  // namespace

std::size_t Dcel::degree(VertexId v) const {
  const HalfedgeId first = (*this)[v].out;
  if (first.is_none()) return 0;
  std::size_t count = 0;
  HalfedgeId h = first;
  do {
    ++count;
    h = clockwise(h);
  } while (h != first);
  return count;
}

Counts count_cells(const Dcel& dcel) {
  Counts counts;
  bool is_framed = false;
  for (const Vertex& vertex : dcel.vertices) {
    is_framed = is_framed || vertex.state == CellState::fictitious;
    if (vertex.state != CellState::real) continue;
    ++counts.vertices;
    counts.isolated_vertices += static_cast<std::size_t>(vertex.out.is_none());
  }
  counts.edges = count_if_alive(dcel.edges, [](CellState state) { return state == CellState::real; });
  for (const Face& face : dcel.faces) {
    if (face.state != CellState::real) continue;
    ++counts.faces;
    counts.unbounded_faces += static_cast<std::size_t>(face.is_unbounded);
  }
  counts.boundaries = count_if_alive(dcel.boundaries, [&](const Boundary& boundary) {
    return !boundary.halfedge.is_none() && dcel[boundary.face].state == CellState::real;
  });
  counts.components = count_components(dcel);
  return counts;
}

void check_links(const Dcel& dcel) {
  check_halfedges(dcel);
  check_vertices(dcel);
  const std::size_t boundaries = check_faces(dcel);
  const std::size_t vertices =
      count_if_alive(dcel.vertices, [](const Vertex& vertex) { return vertex.state != CellState::dead; });
  const std::size_t edges = count_if_alive(dcel.edges, [](CellState state) { return state != CellState::dead; });
  const std::size_t faces = count_if_alive(dcel.faces, [](const Face& face) { return face.state != CellState::dead; });
  const std::size_t components = count_components(dcel);
  require(vertices + faces == edges + 1 + components, "Euler's formula fails, faces:", faces);
  require(boundaries == faces + components - 1, "number of boundaries and isolated vertices:", boundaries);
}

}  // namespace quoin::dcel
