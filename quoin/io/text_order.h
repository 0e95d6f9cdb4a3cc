// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "quoin/arrangement/location/edge_order.h"
#include "quoin/io/arrangement_text.h"
#include "quoin/io/family_text.h"

/// The order in which an exact text names the cells of an arrangement, whatever their ids are.
namespace quoin::io {

template <CurveFamily F>
struct TextOrder {
  std::vector<dcel::VertexId> vertices;  ///< as a sweep meets them first
  std::vector<dcel::EdgeId> edges;       ///< by left end, then from bottom to top
  std::vector<dcel::FaceId> faces;       ///< as edges name them: above each edge, then below it
};

/// Where a sweep meets a vertex first: of a pole, at the first of its edges.
template <CurveFamily F>
std::vector<typename F::Point> first_places(const Arrangement<F>& a) {
  std::vector<typename F::Point> places;
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    places.push_back(a.has_point(dcel::VertexId(v)) ? a.point(dcel::VertexId(v)) : typename F::Point());
  }
  std::vector<bool> is_met(places.size(), false);
  const auto meet = [&](dcel::VertexId v, const typename F::Point& end) {
    if (!is_at_pole(end)) return;
    if (!is_met[v.index()] || a.family().compare_xy(end, places[v.index()]) == Sign::negative) places[v.index()] = end;
    is_met[v.index()] = true;
  };
  for (std::size_t i = 0; IdentifiedFamily<F> && i < a.edge_count(); ++i) {
    const dcel::EdgeId e(i);
    if (!a.cells().is_real(e)) continue;
    meet(a.left(e), a.left_point(e));
    meet(a.right(e), a.right_point(e));
  }
  return places;
}

/// Faces in the order of a list of edges; one without edges is the only one.
template <CurveFamily F>
std::vector<dcel::FaceId> faces_along(const Arrangement<F>& a, const std::vector<dcel::EdgeId>& edges) {
  std::vector<dcel::FaceId> faces;
  std::vector<bool> is_known(a.face_count(), false);
  const auto add = [&](dcel::FaceId f) {
    if (!is_known[f.index()] && a.cells().is_real(f)) faces.push_back(f);
    is_known[f.index()] = true;
  };
  for (const dcel::EdgeId e : edges) {
    add(face_above(a, e));
    add(face_below(a, e));
  }
  for (std::size_t f = 0; f < a.face_count(); ++f) add(dcel::FaceId(f));
  return faces;
}

template <CurveFamily F>
TextOrder<F> text_order(const Arrangement<F>& a) {
  const F& family = a.family();
  TextOrder<F> order;
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    if (is_point_vertex(a, dcel::VertexId(v))) order.vertices.emplace_back(v);
  }
  for (std::size_t e = 0; e < a.edge_count(); ++e) {
    if (a.cells().is_real(dcel::EdgeId(e))) order.edges.emplace_back(e);
  }
  const std::vector<typename F::Point> places = first_places(a);
  const auto vertex_before = [&](dcel::VertexId v, dcel::VertexId w) {
    const auto& p = places[v.index()];
    const auto& q = places[w.index()];
    const int p_rank = rank_of(p, a.cells().is_isolated(v));
    const int q_rank = rank_of(q, a.cells().is_isolated(w));
    return p_rank != q_rank ? p_rank < q_rank : family.compare_xy(p, q) == Sign::negative;
  };
  const auto edge_before = [&](dcel::EdgeId e, dcel::EdgeId f) {
    const Sign ends = family.compare_xy(a.left_point(e), a.left_point(f));
    if (ends != Sign::zero) return ends == Sign::negative;
    return e != f && family.compare_right(a.branch(e), a.branch(f), a.left_point(e)) == Sign::negative;
  };
  if (!std::ranges::is_sorted(order.vertices, vertex_before)) std::ranges::sort(order.vertices, vertex_before);
  if (!std::ranges::is_sorted(order.edges, edge_before)) std::ranges::sort(order.edges, edge_before);
  order.faces = faces_along(a, order.edges);
  return order;
}

/// The members of a set of these faces with their boundaries: what edges and vertices are in a text that says nothing
/// else of them.
template <CurveFamily F>
CellMembers closed_members(const Arrangement<F>& a, std::vector<bool> faces) {
  const dcel::Dcel& cells = a.cells();
  CellMembers members{std::vector<bool>(a.vertex_count(), false), std::vector<bool>(a.edge_count(), false),
                      std::move(faces)};
  for (std::size_t i = 0; i < a.edge_count(); ++i) {
    const dcel::EdgeId e(i);
    if (!cells.is_real(e)) continue;
    if (!members.faces[face_above(a, e).index()] && !members.faces[face_below(a, e).index()]) continue;
    members.edges[i] = true;
    members.vertices[a.left(e).index()] = members.vertices[a.right(e).index()] = true;
  }
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    const dcel::VertexId id(v);
    if (!cells.is_real(id)) {
      members.vertices[v] = false;
    } else if (cells.is_isolated(id)) {
      members.vertices[v] = members.faces[cells[id].face.index()];
    }
  }
  return members;
}

}  // namespace quoin::io
