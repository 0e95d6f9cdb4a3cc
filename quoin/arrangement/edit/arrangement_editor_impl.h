// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "quoin/arrangement/edit/arrangement_editor.h"
#include "quoin/base/error.h"

/// Bodies of ArrangementEditor, for the one source file per family that instantiates it.
namespace quoin {

template <CurveFamily F>
void ArrangementEditor<F>::check_planar() {
  if (!is_planar) throw InputError("insertion of single edges is not supported on this surface");
}

template <CurveFamily F>
void ArrangementEditor<F>::check_order(const Point& left, const Point& right) const {
  check_planar();
  if (a_.family_.compare_xy(left, right) != Sign::negative) throw InputError("new edge: its left end is not the left");
}

template <CurveFamily F>
void ArrangementEditor<F>::check_vertex(dcel::VertexId v) const {
  if (v.index() >= a_.cells_.vertices.size() || !a_.has_point(v) || a_.cells_[v].state == dcel::CellState::dead) {
    throw InputError("there is no vertex " + std::to_string(v.value));
  }
}

template <CurveFamily F>
void ArrangementEditor<F>::check_edge(dcel::EdgeId e) const {
  if (e.index() >= a_.cells_.edges.size() || !a_.cells_.is_real(e)) {
    throw InputError("there is no edge " + std::to_string(e.value));
  }
}

template <CurveFamily F>
void ArrangementEditor<F>::check_face(dcel::FaceId face) const {
  if (face.index() >= a_.cells_.faces.size() || !a_.cells_.is_real(face)) {
    throw InputError("there is no face " + std::to_string(face.value));
  }
}

template <CurveFamily F>
void ArrangementEditor<F>::check_hint(dcel::VertexId v, dcel::HalfedgeId hint) const {
  if (hint.index() < a_.cells_.halfedges.size() && a_.cells_.edges[hint.edge().index()] != dcel::CellState::dead &&
      a_.cells_.target(hint) == v) {
    return;
  }
  throw InputError("halfedge " + std::to_string(hint.value) + " does not arrive at vertex " + std::to_string(v.value));
}

template <CurveFamily F>
dcel::RingPlace ArrangementEditor<F>::at_left_end(dcel::VertexId v, BranchId branch, dcel::HalfedgeId hint) const {
  check_vertex(v);
  if (!hint.is_none()) {
    check_hint(v, hint);
    return {v, hint};
  }
  const RingSearch found = geometry_.place_right(v, branch);
  if (found.overlapped.is_none()) return found.place;
  throw InputError("new edge: it runs along edge " + std::to_string(found.overlapped.value));
}

template <CurveFamily F>
dcel::RingPlace ArrangementEditor<F>::at_right_end(dcel::VertexId v, BranchId branch, dcel::HalfedgeId hint) const {
  check_vertex(v);
  if (!hint.is_none()) {
    check_hint(v, hint);
    return {v, hint};
  }
  const RingSearch found = geometry_.place_left(v, branch);
  if (found.overlapped.is_none()) return found.place;
  throw InputError("new edge: it runs along edge " + std::to_string(found.overlapped.value));
}

/// An end at infinity must lie on the part of the frame that bounds the face.
template <CurveFamily F>
void ArrangementEditor<F>::check_new_end(const Point& end, dcel::FaceId face) const {
  if (a_.family_.side(end) == Side::interior) return;
  if (geometry_.first_corner().is_none()) {
    if (a_.cells_[face].is_unbounded) return;
    throw InputError("new edge: face " + std::to_string(face.value) + " is bounded, the edge is not");
  }
  const auto place = geometry_.frame_place(end);
  if (!place.vertex.is_none()) {
    throw InputError("new edge: its end at infinity is vertex " + std::to_string(place.vertex.value));
  }
  if (a_.cells_.face(place.edge) != face) {
    throw InputError("new edge: it reaches infinity outside face " + std::to_string(face.value));
  }
}

/// Gives appended cells their place in the arrays of points, branches and curves.
template <CurveFamily F>
void ArrangementEditor<F>::fill_columns() {
  a_.points_.resize(std::max(a_.points_.size(), a_.cells_.vertices.size()));
  const std::size_t edges = a_.cells_.edges.size();
  a_.branches_.resize(std::max(a_.branches_.size(), edges));
  while (a_.history_.edge_count() < edges) a_.history_.append({});
}

template <CurveFamily F>
dcel::VertexId ArrangementEditor<F>::insert_vertex(const Point& point, dcel::FaceId face) {
  check_planar();
  check_face(face);
  if (a_.family_.side(point) != Side::interior) throw InputError("new vertex: it lies at infinity");
  fill_columns();
  a_.points_.push_back(point);
  return local_.add_isolated_vertex(face);
}

template <CurveFamily F>
void ArrangementEditor<F>::remove_vertex(dcel::VertexId v) {
  check_vertex(v);
  local_.remove_isolated_vertex(v);
}

template <CurveFamily F>
dcel::RingPlace ArrangementEditor<F>::new_end(const Point& end, dcel::FaceId face) {
  if (a_.family_.side(end) != Side::interior) return new_infinite_end(end);
  return {insert_vertex(end, face), dcel::HalfedgeId()};
}

template <CurveFamily F>
dcel::RingPlace ArrangementEditor<F>::new_infinite_end(const Point& end) {
  if (geometry_.first_corner().is_none()) {
    fill_columns();
    local_.add_frame();
    fill_columns();
  }
  const dcel::HalfedgeId h = geometry_.frame_place(end).edge;
  return {split(h.edge(), end), h};
}

template <CurveFamily F>
dcel::VertexId ArrangementEditor<F>::split(dcel::EdgeId e, const Point& point) {
  fill_columns();
  a_.points_.push_back(point);
  const BranchId branch = a_.branches_[e.index()];
  a_.branches_.push_back(branch);
  const auto uses = a_.history_.of(e);
  a_.history_.append(std::vector<CurveUse>(uses.begin(), uses.end()));
  if (const auto* own = a_.own_ends(e)) {
    const EdgeEnds<Point> ends = *own;
    set_ends(e, ends.left, point);
    set_ends(dcel::EdgeId(a_.branches_.size() - 1), point, ends.right);
  }
  return local_.split_edge(e);
}

/// Keeps the table sorted by edge.
template <CurveFamily F>
void ArrangementEditor<F>::set_ends(dcel::EdgeId e, const Point& left, const Point& right) {
  auto& table = a_.edge_ends_;
  const auto place = std::lower_bound(table.begin(), table.end(), e,
                                      [](const EdgeEnds<Point>& ends, dcel::EdgeId edge) { return ends.edge < edge; });
  if (place != table.end() && place->edge == e) {
    *place = {e, left, right};
  } else {
    table.insert(place, {e, left, right});
  }
}

template <CurveFamily F>
dcel::EdgeId ArrangementEditor<F>::link(const NewEdge& edge, const dcel::RingPlace& left,
                                        const dcel::RingPlace& right) {
  fill_columns();
  a_.branches_.push_back(edge.branch);
  a_.history_.append(edge.curves);
  return local_.insert_edge(left, right);
}

template <CurveFamily F>
dcel::EdgeId ArrangementEditor<F>::insert_in_face(const NewEdge& edge, const Point& left, const Point& right,
                                                  dcel::FaceId face) {
  check_order(left, right);
  check_face(face);
  check_new_end(left, face);
  check_new_end(right, face);
  const dcel::RingPlace from = new_end(left, face);
  const dcel::RingPlace to = new_end(right, face);
  // The second end may have cut the part of the frame that arrives at the first.
  return link(edge, from.arriving.is_none() ? from : dcel::RingPlace{from.vertex, frame_arriving(from.vertex)}, to);
}

template <CurveFamily F>
dcel::HalfedgeId ArrangementEditor<F>::frame_arriving(dcel::VertexId end) const {
  dcel::HalfedgeId out = a_.cells_[end].out;
  while (a_.cells_.is_real(out.edge()) || out.is_forward()) out = a_.cells_.clockwise(out);
  return out.twin();
}

template <CurveFamily F>
dcel::EdgeId ArrangementEditor<F>::insert_from_left(const NewEdge& edge, dcel::VertexId left, const Point& right,
                                                    dcel::HalfedgeId hint) {
  const dcel::RingPlace from = at_left_end(left, edge.branch, hint);
  check_order(a_.point(left), right);
  const dcel::FaceId face = local_.face_of(from);
  check_new_end(right, face);
  return link(edge, from, new_end(right, face));
}

template <CurveFamily F>
dcel::EdgeId ArrangementEditor<F>::insert_from_right(const NewEdge& edge, const Point& left, dcel::VertexId right,
                                                     dcel::HalfedgeId hint) {
  const dcel::RingPlace to = at_right_end(right, edge.branch, hint);
  check_order(left, a_.point(right));
  const dcel::FaceId face = local_.face_of(to);
  check_new_end(left, face);
  return link(edge, new_end(left, face), to);
}

template <CurveFamily F>
dcel::EdgeId ArrangementEditor<F>::insert_between(const NewEdge& edge, dcel::VertexId left, dcel::VertexId right,
                                                  dcel::HalfedgeId left_hint, dcel::HalfedgeId right_hint) {
  const dcel::RingPlace from = at_left_end(left, edge.branch, left_hint);
  const dcel::RingPlace to = at_right_end(right, edge.branch, right_hint);
  check_order(a_.point(left), a_.point(right));
  local_.check_places(from, to);
  return link(edge, from, to);
}

template <CurveFamily F>
dcel::VertexId ArrangementEditor<F>::split_edge(dcel::EdgeId e, const Point& point) {
  check_edge(e);
  if (!spans(a_, e, point) || a_.family_.compare_y_at_x(point, a_.branch(e)) != Sign::zero) {
    throw InputError("edge " + std::to_string(e.value) + " cannot be split at a point that is not inside it");
  }
  return split(e, point);
}

template <CurveFamily F>
bool ArrangementEditor<F>::can_merge(dcel::VertexId v) const {
  const dcel::Dcel& cells = a_.cells_;
  if (!cells.is_real(v) || cells.is_isolated(v) || cells.degree(v) != 2) return false;
  const dcel::HalfedgeId one = cells[v].out;
  const dcel::HalfedgeId other = cells.clockwise(one);
  if (one.is_forward() == other.is_forward() || one.edge() == other.edge()) return false;
  // Copies of the point differ where a curve goes on beyond a glued or contracted side.
  const dcel::EdgeId before = one.is_forward() ? other.edge() : one.edge();
  const dcel::EdgeId after = one.is_forward() ? one.edge() : other.edge();
  if (a_.family_.compare_xy(a_.right_point(before), a_.left_point(after)) != Sign::zero) return false;
  const auto curves = a_.curves(one.edge());
  const auto others = a_.curves(other.edge());
  return std::equal(curves.begin(), curves.end(), others.begin(), others.end()) &&
         a_.family_.same_branch(a_.branch(one.edge()), a_.branch(other.edge()));
}

template <CurveFamily F>
dcel::EdgeId ArrangementEditor<F>::merge_edges(dcel::VertexId v) {
  check_vertex(v);
  if (!can_merge(v)) throw InputError("the edges at vertex " + std::to_string(v.value) + " are not one piece");
  const dcel::HalfedgeId out = a_.cells_[v].out;
  const dcel::EdgeId gone = out.is_forward() ? out.edge() : a_.cells_.clockwise(out).edge();
  const dcel::EdgeId left = out.is_forward() ? a_.cells_.clockwise(out).edge() : out.edge();
  if (a_.own_ends(left) != nullptr || a_.own_ends(gone) != nullptr) {
    const Point from = a_.left_point(left);
    const Point to = a_.right_point(gone);
    set_ends(left, from, to);
  }
  const dcel::EdgeId kept = local_.merge_edges(v);
  a_.history_.assign(gone, {});
  return kept;
}

template <CurveFamily F>
void ArrangementEditor<F>::remove_edge(dcel::EdgeId e, const dcel::RemoveEdgeOptions& options) {
  check_edge(e);
  const dcel::VertexId ends[2] = {a_.left(e), a_.right(e)};
  local_.remove_edge(e, options);
  a_.history_.assign(e, {});
  for (const dcel::VertexId end : ends) {
    if (a_.cells_[end].state == dcel::CellState::fictitious) local_.remove_frame_end(end);
  }
}

template <CurveFamily F>
void ArrangementEditor<F>::set_curves(dcel::EdgeId e, std::span<const CurveUse> curves) {
  check_edge(e);
  a_.observers_.tell(&ArrangementObserver::before_change_curves, e);
  a_.history_.assign(e, curves);
  a_.observers_.tell(&ArrangementObserver::after_change_curves, e);
}

template <CurveFamily F>
void ArrangementEditor<F>::add_curve(dcel::EdgeId e, CurveUse use) {
  check_edge(e);
  const auto old = a_.curves(e);
  std::vector<CurveUse> uses(old.begin(), old.end());
  uses.insert(std::upper_bound(uses.begin(), uses.end(), use), use);
  set_curves(e, uses);
}

template <CurveFamily F>
void ArrangementEditor<F>::replace(Arrangement<F>&& other, const CellMap& map) {
  a_.observers_.tell(&ArrangementObserver::before_global_change);
  ObserverList observers = std::move(a_.observers_);
  a_ = std::move(other);
  a_.observers_ = std::move(observers);
  a_.observers_.tell(&ArrangementObserver::after_global_change, map);
}

}  // namespace quoin
