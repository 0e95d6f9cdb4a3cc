// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>

#include "quoin/arrangement/cells/dcel_filter.h"
#include "quoin/arrangement/cells/face_walk.h"
#include "quoin/arrangement/sets/polygon_set.h"
#include "quoin/arrangement/sets/superposition_impl.h"
#include "quoin/base/error.h"

/// Bodies of polygon_set.h, for the one source file per family that instantiates it.
namespace quoin {

namespace polygon_set_detail {

using dcel::EdgeId;
using dcel::FaceId;
using dcel::HalfedgeId;
using dcel::VertexId;

struct Members {
  std::vector<bool> vertices;
  std::vector<bool> edges;
  std::vector<bool> faces;
};

inline bool is_member_beside(const dcel::Dcel& cells, const std::vector<bool>& faces, EdgeId e) {
  return faces[cells.face(HalfedgeId(e, false)).index()] || faces[cells.face(HalfedgeId(e, true)).index()];
}

/// Calls f for every real edge at v, as an outgoing halfedge.
template <class Call>
void for_each_out(const dcel::Dcel& cells, VertexId v, const Call& call) {
  const HalfedgeId first = cells[v].out;
  if (first.is_none()) return;
  HalfedgeId out = first;
  do {
    if (cells.is_real(out.edge())) call(out);
    out = cells.clockwise(out);
  } while (out != first);
}

/// Edges and vertices next to member faces become members, all others not.
inline void close_faces(const dcel::Dcel& cells, Members& members) {
  members.edges.assign(cells.edges.size(), false);
  members.vertices.assign(cells.vertices.size(), false);
  for (std::size_t e = 0; e < cells.edges.size(); ++e) {
    if (cells.is_real(EdgeId(e))) members.edges[e] = is_member_beside(cells, members.faces, EdgeId(e));
  }
  for (std::size_t v = 0; v < cells.vertices.size(); ++v) {
    if (!cells.is_real(VertexId(v))) continue;
    if (cells.is_isolated(VertexId(v))) members.vertices[v] = members.faces[cells.vertices[v].face.index()];
    for_each_out(cells, VertexId(v), [&](HalfedgeId out) {
      if (members.edges[out.edge().index()]) members.vertices[v] = true;
    });
  }
}

/// What simplification keeps and dissolves.
template <CurveFamily F>
dcel::Filter redundancy(const Arrangement<F>& arrangement, const Members& members) {
  const dcel::Dcel& cells = arrangement.cells();
  dcel::Filter filter{std::vector<bool>(cells.edges.size(), false), std::vector<bool>(cells.vertices.size(), false),
                      std::vector<bool>(cells.vertices.size(), false)};
  for (std::size_t e = 0; e < cells.edges.size(); ++e) {
    if (!cells.is_real(EdgeId(e))) continue;
    const bool above = members.faces[cells.face(HalfedgeId(EdgeId(e), false)).index()];
    const bool below = members.faces[cells.face(HalfedgeId(EdgeId(e), true)).index()];
    filter.keep_edge[e] = members.edges[e] != above || members.edges[e] != below;
  }
  for (std::size_t i = 0; i < cells.vertices.size(); ++i) {
    const VertexId v(i);
    if (cells[v].state == dcel::CellState::dead) continue;
    std::vector<HalfedgeId> kept;
    for_each_out(cells, v, [&](HalfedgeId out) {
      if (filter.keep_edge[out.edge().index()]) kept.push_back(out);
    });
    if (!cells.is_real(v)) {  // at infinity: stays while a curve ends there; the corners of the frame always
      filter.dissolve_vertex[i] = kept.empty() && arrangement.has_point(v);
      continue;
    }
    const HalfedgeId out = cells[v].out;
    const FaceId face = out.is_none() ? cells[v].face : cells.face(out);
    filter.keep_vertex[i] = !kept.empty() || members.vertices[i] != members.faces[face.index()];
    filter.dissolve_vertex[i] =
        kept.size() == 2 && kept[0].is_forward() != kept[1].is_forward() &&
        members.vertices[i] == members.edges[kept[0].edge().index()] &&
        members.vertices[i] == members.edges[kept[1].edge().index()] &&
        arrangement.family().side(arrangement.point(v)) == Side::interior &&
        arrangement.family().same_branch(arrangement.branch(kept[0].edge()), arrangement.branch(kept[1].edge()));
  }
  return filter;
}

template <CurveFamily F>
Arrangement<F> filtered_arrangement(const Arrangement<F>& from, dcel::Filtered& filtered) {
  std::vector<typename F::Point> points;
  for (const VertexId v : filtered.source_of_vertex) {
    if (from.has_point(v)) points.push_back(from.point(v));
  }
  std::vector<BranchId> branches;
  std::vector<EdgeEnds<typename F::Point>> ends;
  CurveHistory history;
  for (std::size_t e = 0; e < filtered.first_source_of_edge.size(); ++e) {
    const EdgeId first = filtered.first_source_of_edge[e];
    const bool is_real = from.cells().is_real(first);
    branches.push_back(is_real ? from.branch(first) : BranchId());
    history.append(is_real ? from.curves(first) : std::span<const CurveUse>());
    if constexpr (F::Surface::sides.left == SideKind::identified) {
      const EdgeId last = filtered.last_source_of_edge[e];
      if (from.own_ends(first) != nullptr || from.own_ends(last) != nullptr) {
        ends.push_back({EdgeId(e), from.left_point(first), from.right_point(last)});
      }
    }
  }
  Arrangement<F> result(from.family(), std::move(filtered.dcel), std::move(points), std::move(branches),
                        std::move(history), from.curve_count());
  result.set_edge_ends(std::move(ends));
  return result;
}

}  // namespace polygon_set_detail

template <CurveFamily F>
PolygonSet<F>::PolygonSet() : faces_(arrangement_.face_count(), false) {}

template <CurveFamily F>
PolygonSet<F>::PolygonSet(const Arrangement<F>& arrangement, std::vector<bool> vertices, std::vector<bool> edges,
                          std::vector<bool> faces) {
  const polygon_set_detail::Members members{std::move(vertices), std::move(edges), std::move(faces)};
  dcel::Filtered filtered = dcel::filter(arrangement.cells(), polygon_set_detail::redundancy(arrangement, members));
  // Whatever was said of fictitious cells: they are no members.
  for (const dcel::VertexId v : filtered.source_of_vertex) {
    vertices_.push_back(arrangement.cells().is_real(v) && members.vertices[v.index()]);
  }
  for (const dcel::EdgeId e : filtered.first_source_of_edge) {
    edges_.push_back(arrangement.cells().is_real(e) && members.edges[e.index()]);
  }
  faces_.resize(filtered.dcel.faces.size());
  for (std::size_t f = 0; f < members.faces.size(); ++f) {
    const dcel::FaceId face = filtered.face_of_source[f];
    const bool is_real = arrangement.cells().is_real(dcel::FaceId(f));
    if (!face.is_none() && is_real && members.faces[f]) faces_[face.index()] = true;
  }
  arrangement_ = polygon_set_detail::filtered_arrangement(arrangement, filtered);
}

template <CurveFamily F>
bool PolygonSet<F>::is_empty() const {
  const auto none_is_set = [](const std::vector<bool>& bits) {
    return std::find(bits.begin(), bits.end(), true) == bits.end();
  };
  return none_is_set(vertices_) && none_is_set(edges_) && none_is_set(faces_);
}

template <CurveFamily F>
bool PolygonSet<F>::is_everything() const {
  return complement().is_empty();
}

template <CurveFamily F>
bool PolygonSet<F>::is_unbounded() const {
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (faces_[f] && arrangement_.cells().faces[f].is_unbounded) return true;
  }
  return false;
}

template <CurveFamily F>
bool PolygonSet<F>::is_regular() const {
  polygon_set_detail::Members members{{}, {}, faces_};
  polygon_set_detail::close_faces(arrangement_.cells(), members);
  return members.edges == edges_ && members.vertices == vertices_;
}

template <CurveFamily F>
PolygonSet<F> PolygonSet<F>::complement() const {
  polygon_set_detail::Members members{vertices_, edges_, faces_};
  const dcel::Dcel& cells = arrangement_.cells();
  for (std::size_t v = 0; v < cells.vertices.size(); ++v) {
    members.vertices[v] = cells.is_real(dcel::VertexId(v)) && !vertices_[v];
  }
  for (std::size_t e = 0; e < cells.edges.size(); ++e) {
    members.edges[e] = cells.is_real(dcel::EdgeId(e)) && !edges_[e];
  }
  for (std::size_t f = 0; f < cells.faces.size(); ++f) {
    members.faces[f] = cells.is_real(dcel::FaceId(f)) && !faces_[f];
  }
  return PolygonSet(arrangement_, std::move(members.vertices), std::move(members.edges), std::move(members.faces));
}

template <CurveFamily F>
PolygonSet<F> PolygonSet<F>::interior() const {
  return PolygonSet(arrangement_, std::vector<bool>(vertices_.size(), false), std::vector<bool>(edges_.size(), false),
                    faces_);
}

template <CurveFamily F>
PolygonSet<F> PolygonSet<F>::closure() const {
  polygon_set_detail::Members members{{}, {}, faces_};
  polygon_set_detail::close_faces(arrangement_.cells(), members);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (!edges_[e]) continue;
    members.edges[e] = true;
    for (const bool end : {false, true}) {
      members.vertices[arrangement_.cells().origin(dcel::HalfedgeId(dcel::EdgeId(e), end)).index()] = true;
    }
  }
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    if (vertices_[v]) members.vertices[v] = true;
  }
  return PolygonSet(arrangement_, std::move(members.vertices), std::move(members.edges), std::move(members.faces));
}

/// The closure less the interior. Nothing is simplified in between, so that an inner cut line stays.
template <CurveFamily F>
PolygonSet<F> PolygonSet<F>::boundary() const {
  PolygonSet closed = closure();
  std::fill(closed.faces_.begin(), closed.faces_.end(), false);
  const dcel::Dcel& cells = closed.arrangement_.cells();
  for (std::size_t v = 0; v < closed.vertices_.size(); ++v) {
    if (!cells.is_real(dcel::VertexId(v))) closed.vertices_[v] = false;
  }
  return PolygonSet(closed.arrangement_, closed.vertices_, closed.edges_, closed.faces_);
}

template <CurveFamily F>
PolygonSet<F> PolygonSet<F>::regularized() const {
  polygon_set_detail::Members members{{}, {}, faces_};
  polygon_set_detail::close_faces(arrangement_.cells(), members);
  return PolygonSet(arrangement_, std::move(members.vertices), std::move(members.edges), std::move(members.faces));
}

}  // namespace quoin
