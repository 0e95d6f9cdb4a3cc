// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/cells/dcel_builder.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace quoin::dcel {

namespace {

HalfedgeId forward(std::uint32_t edge) {
  return HalfedgeId(EdgeId(std::size_t{edge}), false);
}
HalfedgeId backward(std::uint32_t edge) {
  return HalfedgeId(EdgeId(std::size_t{edge}), true);
}

}  // namespace

void DcelBuilder::reserve(std::size_t events, std::size_t edges) {
  dcel_.vertices.reserve(events);
  dcel_.halfedges.reserve(2 * edges);
  dcel_.edges.reserve(edges);
}

void DcelBuilder::add_event(const LinkEvent& event) {
  const std::uint32_t vertex = event_count_++;
  dcel_.vertices.emplace_back();
  start_edges(vertex, event.right);
  for (const std::uint32_t edge : event.left) dcel_[backward(edge)].origin = VertexId(std::size_t{vertex});
  if (event.side == Side::interior) {
    ring_.clear();
    for (const std::uint32_t edge : event.right) ring_.push_back(forward(edge));
    for (std::size_t i = event.left.size(); i-- > 0;) ring_.push_back(backward(event.left[i]));
    link_ring(vertex, ring_);
    if (event.left.empty()) extremes_.push_back({vertex, event.below, bottom_count_});
    return;
  }
  SideEvent side{vertex, event.side, event.left_copy, {}, {}, {}};
  for (const std::uint32_t edge : event.right) side.up.push_back(forward(edge));
  for (std::size_t i = event.left.size(); i-- > 0;) side.down.push_back(backward(event.left[i]));
  if (event.side == Side::bottom && !side.up.empty()) ++bottom_count_;
  sides_.push_back(std::move(side));
}

void DcelBuilder::start_edges(std::uint32_t event, std::span<const std::uint32_t> edges) {
  const std::size_t first = dcel_.halfedges.size();
  dcel_.edges.resize(dcel_.edges.size() + edges.size(), CellState::real);
  dcel_.halfedges.resize(first + 2 * edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) dcel_.halfedges[first + 2 * i].origin = VertexId(std::size_t{event});
}

/// The outgoing halfedges of a vertex, counterclockwise: what arrives along one leaves along the one before.
void DcelBuilder::link_ring(std::uint32_t vertex, std::span<const HalfedgeId> outgoing) {
  if (outgoing.empty()) return;
  dcel_.vertices[vertex].out = outgoing[0];
  HalfedgeId before = outgoing.back();
  for (const HalfedgeId out : outgoing) {
    dcel_.link(out.twin(), before);
    before = out;
  }
}

void DcelBuilder::set_origins(std::uint32_t vertex, std::span<const HalfedgeId> outgoing) {
  for (const HalfedgeId out : outgoing) dcel_[out].origin = VertexId(std::size_t{vertex});
}

DcelBuilder::Result DcelBuilder::finish(SideKinds kinds, bool has_unbounded_face) {
  kinds_ = kinds;
  has_unbounded_face_ = has_unbounded_face;
  if (!sides_.empty()) {
    merged_into_.resize(event_count_);
    std::iota(merged_into_.begin(), merged_into_.end(), 0U);
  }
  if (kinds.left == SideKind::infinite) join_infinite_sides();
  if (kinds.bottom == SideKind::contracted) join_contracted_side(Side::bottom);
  if (kinds.top == SideKind::contracted) join_contracted_side(Side::top);
  if (kinds.left == SideKind::identified) join_identified_sides();
  trace_boundaries();
  unite_faces();
  number_faces();
  hang_boundaries();
  if (has_unbounded_face) mark_outer_boundaries();
  hang_isolated_vertices();
  return number_vertices();
}

std::uint32_t DcelBuilder::add_corner() {
  dcel_.vertices.emplace_back().state = CellState::fictitious;
  return static_cast<std::uint32_t>(dcel_.vertices.size() - 1);
}

/// Counterclockwise: along the bottom from left to right, up the right side, back along the top, down the left side.
void DcelBuilder::join_infinite_sides() {
  if (sides_.empty()) return;
  std::vector<FramePlace> frame;
  std::size_t bottom_places = 0;
  const auto add_side = [&](Side side, bool forwards) {
    frame.push_back({add_corner(), HalfedgeId()});
    const std::size_t begin = frame.size();
    for (const SideEvent& event : sides_) {
      if (event.side != side) continue;
      dcel_.vertices[event.event].state = CellState::fictitious;
      frame.push_back({event.event, event.up.empty() ? event.down[0] : event.up[0]});
    }
    if (!forwards) std::reverse(frame.begin() + static_cast<std::ptrdiff_t>(begin), frame.end());
    if (side == Side::bottom) bottom_places = frame.size();
  };
  add_side(Side::bottom, true);
  add_side(Side::right, true);
  add_side(Side::top, false);
  add_side(Side::left, false);
  const std::size_t first_edge = dcel_.edges.size();
  link_frame(frame);
  for (std::size_t i = 0; i < bottom_places; ++i) frame_bottom_.push_back(HalfedgeId(EdgeId(first_edge + i), false));
}

void DcelBuilder::link_frame(std::span<const FramePlace> frame) {
  const std::size_t first_edge = dcel_.edges.size();
  const std::size_t count = frame.size();
  for (std::size_t i = 0; i < count; ++i) {
    dcel_.edges.push_back(CellState::fictitious);
    dcel_.halfedges.emplace_back().origin = VertexId(std::size_t{frame[i].vertex});
    dcel_.halfedges.emplace_back().origin = VertexId(std::size_t{frame[(i + 1) % count].vertex});
  }
  for (std::size_t i = 0; i < count; ++i) {
    const HalfedgeId in(EdgeId(first_edge + (i + count - 1) % count), false);
    const HalfedgeId out(EdgeId(first_edge + i), false);
    dcel_.vertices[frame[i].vertex].out = out;
    dcel_.link(out.twin(), in.twin());
    if (frame[i].inwards.is_none()) {
      dcel_.link(in, out);
    } else {
      dcel_.link(in, frame[i].inwards);
      dcel_.link(frame[i].inwards.twin(), out);
    }
  }
}

/// Seen from outside, a ring around the top side runs with x, one around the bottom against it.
void DcelBuilder::join_contracted_side(Side side) {
  std::vector<HalfedgeId>& edges = side == Side::bottom ? bottom_edges_ : top_edges_;
  std::uint32_t vertex = none;
  for (const SideEvent& event : sides_) {
    if (event.side != side) continue;
    if (vertex == none) vertex = event.event;
    merged_into_[event.event] = vertex;
    edges.insert(edges.end(), event.up.begin(), event.up.end());
    edges.insert(edges.end(), event.down.begin(), event.down.end());
  }
  if (vertex == none) return;
  std::vector<HalfedgeId> ring(edges);
  if (side == Side::bottom) std::reverse(ring.begin(), ring.end());
  set_origins(vertex, ring);
  link_ring(vertex, ring);
  if (ring.empty()) lone_poles_.emplace_back(vertex, side);
}

void DcelBuilder::join_identified_sides() {
  for (SideEvent& right : sides_) {
    if (right.side != Side::right) continue;
    const auto left = std::lower_bound(sides_.begin(), sides_.end(), right.left_copy,
                                       [](const SideEvent& s, std::uint32_t event) { return s.event < event; });
    merged_into_[right.event] = left->event;
    left->after_copy.insert(left->after_copy.end(), right.down.begin(), right.down.end());
  }
  for (const SideEvent& left : sides_) {
    if (left.side != Side::left) continue;
    ring_ = left.up;
    ring_.insert(ring_.end(), left.after_copy.begin(), left.after_copy.end());
    ring_.insert(ring_.end(), left.down.begin(), left.down.end());
    set_origins(left.event, ring_);
    link_ring(left.event, ring_);
  }
}

void DcelBuilder::trace_boundaries() {
  // What Euler's formula gives for one component.
  if (dcel_.edges.size() > dcel_.vertices.size()) {
    const std::size_t likely = dcel_.edges.size() - dcel_.vertices.size() + 2;
    dcel_.boundaries.reserve(likely);
    dcel_.faces.reserve(likely);
  }
  for (std::size_t i = 0; i < dcel_.halfedges.size(); ++i) {
    if (!dcel_.halfedges[i].boundary.is_none()) continue;
    const BoundaryId boundary(dcel_.boundaries.size());
    dcel_.boundaries.push_back({HalfedgeId(i), FaceId(), BoundaryId(), !has_unbounded_face_});
    HalfedgeId h(i);
    do {
      dcel_[h].boundary = boundary;
      h = dcel_.next(h);
    } while (h != HalfedgeId(i));
  }
}

std::uint32_t DcelBuilder::class_below(const Extreme& extreme) const {
  if (extreme.below != none) return boundary_class(forward(extreme.below));
  if (!frame_bottom_.empty()) return boundary_class(frame_bottom_[extreme.bottom_count]);
  if (bottom_edges_.empty()) return low_class_;
  // Between meridians that leave the bottom side: right of the last one before, or left of the first of all.
  if (extreme.bottom_count == 0) return boundary_class(bottom_edges_[0]);
  return boundary_class(bottom_edges_[extreme.bottom_count - 1].twin());
}

void DcelBuilder::unite_faces() {
  low_class_ = static_cast<std::uint32_t>(dcel_.boundaries.size());
  high_class_ = low_class_ + 1;
  classes_.emplace(dcel_.boundaries.size() + 2);
  for (const Extreme& extreme : extremes_) {
    const HalfedgeId out = dcel_.vertices[extreme.event].out;
    if (out.is_none()) {
      isolated_.emplace_back(extreme.event, class_below(extreme));
    } else {
      classes_->unite(boundary_class(out.twin()), class_below(extreme));
    }
  }
  for (const auto& pole : lone_poles_) {
    isolated_.emplace_back(pole.first, pole.second == Side::bottom ? low_class_ : high_class_);
  }
  if (kinds_.left == SideKind::identified) unite_across_identification();
}

/// Along the identification from bottom to top: where no edge joins one vertex to the next, the wedge that looks up
/// from the one and the wedge that looks down from the other belong to one face.
void DcelBuilder::unite_across_identification() {
  std::uint32_t up = bottom_edges_.empty() ? low_class_ : boundary_class(bottom_edges_[0]);
  bool is_closed_above = false;
  for (const SideEvent& event : sides_) {
    if (event.side != Side::left) continue;
    if (dcel_.vertices[event.event].out.is_none()) {
      isolated_.emplace_back(event.event, up);
      continue;
    }
    const bool has_west = !event.after_copy.empty();
    // In the ring the edges to the right come first, then those of the right copy, then the one downwards.
    const HalfedgeId last = !event.down.empty() ? event.down.back()
                            : has_west          ? event.after_copy.back()
                                                : event.up.back();
    if (event.down.empty()) classes_->unite(up, boundary_class(last));
    const HalfedgeId before_up = event.up.empty() ? last : event.up.back();
    up = boundary_class(before_up);
    is_closed_above =
        !event.up.empty() && !top_edges_.empty() && dcel_.target(event.up.back()) == dcel_.origin(top_edges_[0]);
  }
  if (is_closed_above) return;
  classes_->unite(up, top_edges_.empty() ? high_class_ : boundary_class(top_edges_.back()));
}

FaceId DcelBuilder::add_face(std::uint32_t root) {
  face_of_class_[root] = FaceId(dcel_.faces.size());
  dcel_.faces.emplace_back();
  return face_of_class_[root];
}

void DcelBuilder::number_faces() {
  face_of_class_.assign(classes_->size(), FaceId());
  const bool is_framed = !frame_bottom_.empty();
  const std::uint32_t outside = is_framed ? classes_->find(boundary_class(frame_bottom_[0].twin())) : none;
  // Where meridians leave the bottom side, or a frame closes the plane, the low class stands for no face.
  if (!is_framed && bottom_edges_.empty()) add_face(classes_->find(low_class_));
  for (std::uint32_t b = 0; b < dcel_.boundaries.size(); ++b) {
    const std::uint32_t root = classes_->find(b);
    if (root != outside && face_of_class_[root].is_none()) add_face(root);
  }
  if (is_framed) dcel_[add_face(outside)].state = CellState::fictitious;
  const std::uint32_t base = is_framed               ? boundary_class(frame_bottom_[0])
                             : bottom_edges_.empty() ? low_class_
                                                     : boundary_class(bottom_edges_[0]);
  dcel_.base_face = face_of_class_[classes_->find(base)];
  if (has_unbounded_face_ && !is_framed) dcel_.faces[0].is_unbounded = true;
}

void DcelBuilder::hang_boundaries() {
  for (std::size_t i = dcel_.boundaries.size(); i-- > 0;) {
    Boundary& boundary = dcel_.boundaries[i];
    boundary.face = face_of_class_[classes_->find(static_cast<std::uint32_t>(i))];
    boundary.next = dcel_[boundary.face].first_boundary;
    dcel_[boundary.face].first_boundary = BoundaryId(i);
  }
  for (std::size_t e = dcel_.edges.size(); e-- > 0 && dcel_.edges[e] == CellState::fictitious;) {
    dcel_[dcel_.face(HalfedgeId(EdgeId(e), false))].is_unbounded = true;
  }
}

/// A boundary is outer unless at its smallest vertex, coming from the right and leaving to the right, the wedge on its
/// left holds the direction to the left: then it leaves along an edge that is not below the one it came along.
void DcelBuilder::mark_outer_boundaries() {
  struct Least {
    std::uint32_t vertex = none;
    bool is_inner = false;
  };
  std::vector<Least> least(dcel_.boundaries.size());
  std::vector<bool> is_frame(dcel_.boundaries.size(), false);
  for (std::size_t i = 0; i < dcel_.halfedges.size(); ++i) {
    const HalfedgeId h(i);
    const std::uint32_t b = dcel_[h].boundary.value;
    if (dcel_.edges[h.edge().index()] == CellState::fictitious) is_frame[b] = true;
    const HalfedgeId before = dcel_.previous(h);
    if (!h.is_forward() || before.is_forward()) continue;
    const std::uint32_t vertex = dcel_.origin(h).value;
    const bool is_inner = before.twin() <= h;
    if (vertex < least[b].vertex) {
      least[b] = {vertex, is_inner};
    } else if (vertex == least[b].vertex) {
      least[b].is_inner = least[b].is_inner || is_inner;
    }
  }
  for (std::size_t b = 0; b < least.size(); ++b) dcel_.boundaries[b].is_outer = is_frame[b] || !least[b].is_inner;
}

void DcelBuilder::hang_isolated_vertices() {
  std::sort(isolated_.begin(), isolated_.end());
  for (std::size_t i = isolated_.size(); i-- > 0;) {
    Vertex& vertex = dcel_.vertices[isolated_[i].first];
    vertex.face = face_of_class_[classes_->find(isolated_[i].second)];
    vertex.next_isolated = dcel_[vertex.face].first_isolated;
    dcel_[vertex.face].first_isolated = VertexId(std::size_t{isolated_[i].first});
  }
}

/// Merged vertices go, fictitious ones move behind the real ones.
DcelBuilder::Result DcelBuilder::number_vertices() {
  Result result;
  if (sides_.empty()) {
    result.dcel = std::move(dcel_);
    *this = DcelBuilder();
    return result;
  }
  std::vector<VertexId> number(dcel_.vertices.size());
  LargeVector<Vertex> vertices;
  vertices.reserve(dcel_.vertices.size());
  for (const CellState state : {CellState::real, CellState::fictitious}) {
    for (std::uint32_t v = 0; v < dcel_.vertices.size(); ++v) {
      if (dcel_.vertices[v].state != state || (v < event_count_ && merged_into_[v] != v)) continue;
      number[v] = VertexId(vertices.size());
      vertices.push_back(dcel_.vertices[v]);
    }
  }
  for (Vertex& vertex : vertices) {
    if (!vertex.next_isolated.is_none()) vertex.next_isolated = number[vertex.next_isolated.index()];
  }
  for (Halfedge& halfedge : dcel_.halfedges) halfedge.origin = number[halfedge.origin.index()];
  for (Face& face : dcel_.faces) {
    if (!face.first_isolated.is_none()) face.first_isolated = number[face.first_isolated.index()];
  }
  dcel_.vertices = std::move(vertices);
  result.vertex_of_event.resize(event_count_);
  for (std::uint32_t v = 0; v < event_count_; ++v) result.vertex_of_event[v] = number[merged_into_[v]];
  result.dcel = std::move(dcel_);
  *this = DcelBuilder();
  return result;
}

}  // namespace quoin::dcel
