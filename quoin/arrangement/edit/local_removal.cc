// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "quoin/arrangement/edit/local_edits.h"

/// Removal of edges, and what it does to boundaries and faces.
namespace quoin::dcel {

using Observer = ArrangementObserver;

void LocalEditor::remove_edge(EdgeId e, const RemoveEdgeOptions& options) {
  HalfedgeId h(e, false);
  if (dcel_[h].boundary != dcel_[h.twin()].boundary) {
    // The face that lies around the other, if any does, is kept.
    if (dcel_[dcel_[h].boundary].is_outer && !dcel_[dcel_[h.twin()].boundary].is_outer) h = h.twin();
    remove_between_faces(h, options);
  } else {
    remove_in_face(h, options);
  }
}

/// Takes the edge out of the rings at its ends; ends without other edges have no outgoing halfedge afterwards.
void LocalEditor::unlink(HalfedgeId h) {
  for (const HalfedgeId out : {h, h.twin()}) {
    const VertexId v = dcel_.origin(out);
    const HalfedgeId before = dcel_.previous(out);
    const HalfedgeId after = dcel_.next(out.twin());
    if (after == out) {
      dcel_[v].out = HalfedgeId();
      continue;
    }
    dcel_.link(before, after);
    if (dcel_[v].out == out) dcel_[v].out = after;
  }
}

/// The face on the left of `h` is kept.
void LocalEditor::remove_between_faces(HalfedgeId h, const RemoveEdgeOptions& options) {
  const BoundaryId kept = dcel_[h].boundary;
  const BoundaryId gone = dcel_[h.twin()].boundary;
  const FaceId kept_face = dcel_[kept].face;
  const FaceId gone_face = dcel_[gone].face;
  observers_.tell(&Observer::before_remove_edge, h.edge());
  observers_.tell(&Observer::before_merge_faces, kept_face, gone_face);
  // On the left of h a cycle remains unless h is all of it, a loop; so on the other side.
  const HalfedgeId rest = dcel_.next(h) != h ? dcel_.next(h) : dcel_.next(h.twin());
  const VertexId v = dcel_.origin(h);
  const bool is_loop = v == dcel_.target(h);
  if (!is_loop) {
    unlink(h);
  } else {
    const bool left_alone = dcel_.next(h) == h;
    const bool right_alone = dcel_.next(h.twin()) == h.twin();
    const HalfedgeId arrive = left_alone ? dcel_.previous(h.twin()) : dcel_.previous(h);
    const HalfedgeId leave = right_alone ? dcel_.next(h) : dcel_.next(h.twin());
    if (!left_alone && !right_alone) dcel_.link(dcel_.previous(h.twin()), dcel_.next(h));
    if (!left_alone || !right_alone) dcel_.link(arrive, left_alone ? dcel_.next(h.twin()) : leave);
    dcel_[v].out = left_alone && right_alone ? HalfedgeId() : dcel_.next(arrive);
  }
  dcel_.edges[h.edge().index()] = CellState::dead;
  const bool vanishes = is_loop && dcel_[v].out.is_none();
  kill(gone);
  empty_into(gone_face, kept_face);
  if (vanishes) {
    kill(kept);
    isolate(v, kept_face);
  } else {
    dcel_[kept].halfedge = rest;
    relabel(rest, kept);
  }
  observers_.tell(&Observer::after_remove_edge, h.edge());
  observers_.tell(&Observer::after_merge_faces, kept_face, gone_face);
  if (vanishes && options.removes_left_end && options.removes_right_end) remove_isolated_vertex(v);
}

void LocalEditor::empty_into(FaceId from, FaceId to) {
  while (!dcel_[from].first_boundary.is_none()) {
    const BoundaryId b = dcel_[from].first_boundary;
    unlist(b);
    list(b, to);
  }
  while (!dcel_[from].first_isolated.is_none()) {
    const VertexId v = dcel_[from].first_isolated;
    unisolate(v);
    isolate(v, to);
  }
  dcel_[to].is_unbounded = dcel_[to].is_unbounded || dcel_[from].is_unbounded;
  dcel_[from] = Face{BoundaryId(), VertexId(), false, CellState::dead};
  if (dcel_.base_face == from) dcel_.base_face = to;
}

void LocalEditor::remove_in_face(HalfedgeId h, const RemoveEdgeOptions& options) {
  const BoundaryId boundary = dcel_[h].boundary;
  const FaceId face = dcel_[boundary].face;
  const VertexId left = dcel_.origin(h);
  const VertexId right = dcel_.target(h);
  observers_.tell(&Observer::before_remove_edge, h.edge());
  const HalfedgeId at_right = dcel_.next(h);
  const HalfedgeId at_left = dcel_.next(h.twin());
  const bool goes_on_right = at_right != h.twin();
  const bool goes_on_left = at_left != h;
  unlink(h);
  dcel_.edges[h.edge().index()] = CellState::dead;
  if (goes_on_left && goes_on_right) {
    split_boundary(at_left, at_right, boundary);
  } else if (goes_on_left || goes_on_right) {
    dcel_[boundary].halfedge = goes_on_left ? at_left : at_right;
  } else {
    kill(boundary);
  }
  if (!goes_on_left) isolate(left, face);
  if (!goes_on_right) isolate(right, face);
  observers_.tell(&Observer::after_remove_edge, h.edge());
  if (!goes_on_left && options.removes_left_end) remove_isolated_vertex(left);
  if (!goes_on_right && options.removes_right_end) remove_isolated_vertex(right);
}

/// A component fell apart; if its boundary was an outer one, one of the parts is inside the other.
void LocalEditor::split_boundary(HalfedgeId first, HalfedgeId second, BoundaryId boundary) {
  const bool was_outer = is_planar_ && dcel_[boundary].is_outer;
  if (was_outer && !geometry_.is_outer(first)) std::swap(first, second);
  dcel_[boundary].halfedge = first;
  relabel(second, new_boundary(second, dcel_[boundary].face, false));
}

}  // namespace quoin::dcel
