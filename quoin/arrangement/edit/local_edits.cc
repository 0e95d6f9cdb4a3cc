// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/edit/local_edits.h"

#include <string>

#include "quoin/base/error.h"

namespace quoin::dcel {

using Observer = ArrangementObserver;

VertexId LocalEditor::add_isolated_vertex(FaceId face, CellState state) {
  observers_.tell(&Observer::before_create_vertex);
  const VertexId v(dcel_.vertices.size());
  dcel_.vertices.emplace_back().state = state;
  isolate(v, face);
  observers_.tell(&Observer::after_create_vertex, v);
  return v;
}

void LocalEditor::remove_isolated_vertex(VertexId v) {
  if (!dcel_.is_isolated(v)) throw InputError("vertex " + std::to_string(v.value) + " has edges");
  observers_.tell(&Observer::before_remove_vertex, v);
  unisolate(v);
  dcel_[v].state = CellState::dead;
  observers_.tell(&Observer::after_remove_vertex, v);
}

void LocalEditor::isolate(VertexId v, FaceId face) {
  Vertex& vertex = dcel_[v];
  vertex.out = HalfedgeId();
  vertex.face = face;
  vertex.next_isolated = dcel_[face].first_isolated;
  dcel_[face].first_isolated = v;
}

void LocalEditor::unisolate(VertexId v) {
  VertexId* link = &dcel_[dcel_[v].face].first_isolated;
  while (*link != v) link = &dcel_[*link].next_isolated;
  *link = dcel_[v].next_isolated;
  dcel_[v].next_isolated = VertexId();
  dcel_[v].face = FaceId();
}

void LocalEditor::list(BoundaryId boundary, FaceId face) {
  dcel_[boundary].face = face;
  dcel_[boundary].next = dcel_[face].first_boundary;
  dcel_[face].first_boundary = boundary;
}

void LocalEditor::unlist(BoundaryId boundary) {
  BoundaryId* link = &dcel_[dcel_[boundary].face].first_boundary;
  while (*link != boundary) link = &dcel_[*link].next;
  *link = dcel_[boundary].next;
  dcel_[boundary].next = BoundaryId();
}

BoundaryId LocalEditor::new_boundary(HalfedgeId h, FaceId face, bool is_outer) {
  const BoundaryId boundary(dcel_.boundaries.size());
  dcel_.boundaries.push_back({h, face, BoundaryId(), is_outer || !is_planar_});
  list(boundary, face);
  return boundary;
}

void LocalEditor::kill(BoundaryId boundary) {
  unlist(boundary);
  dcel_[boundary] = Boundary();
}

void LocalEditor::relabel(HalfedgeId start, BoundaryId boundary) {
  HalfedgeId h = start;
  do {
    dcel_[h].boundary = boundary;
    h = dcel_.next(h);
  } while (h != start);
}

bool LocalEditor::has_fictitious_edge(HalfedgeId start) const {
  HalfedgeId h = start;
  do {
    if (dcel_.edges[h.edge().index()] == CellState::fictitious) return true;
    h = dcel_.next(h);
  } while (h != start);
  return false;
}

EdgeId LocalEditor::new_edge(VertexId left, VertexId right, CellState state) {
  const EdgeId e(dcel_.edges.size());
  dcel_.edges.push_back(state);
  dcel_.halfedges.emplace_back().origin = left;
  dcel_.halfedges.emplace_back().origin = right;
  return e;
}

void LocalEditor::check_places(const RingPlace& left, const RingPlace& right) const {
  if (face_of(left) == face_of(right)) return;
  throw InputError("no edge can join vertices " + std::to_string(left.vertex.value) + " and " +
                   std::to_string(right.vertex.value) + " there: their faces differ");
}

EdgeId LocalEditor::insert_edge(const RingPlace& left, const RingPlace& right) {
  check_places(left, right);
  const FaceId face = face_of(left);
  const bool splits = !left.arriving.is_none() && !right.arriving.is_none() &&
                      dcel_[left.arriving].boundary == dcel_[right.arriving].boundary;
  observers_.tell(&Observer::before_create_edge, left.vertex, right.vertex);
  if (splits) observers_.tell(&Observer::before_split_face, face);
  const EdgeId e = new_edge(left.vertex, right.vertex, CellState::real);
  const HalfedgeId h(e, false);
  if (splits) {
    split_face(h, left, right);
    return e;
  }
  if (left.arriving.is_none() && right.arriving.is_none()) {
    open_component(h, face);
  } else if (right.arriving.is_none()) {
    hang_antenna(h, left.arriving);
  } else if (left.arriving.is_none()) {
    hang_antenna(h.twin(), right.arriving);
  } else {
    join_boundaries(h, left, right);
  }
  observers_.tell(&Observer::after_create_edge, e);
  return e;
}

void LocalEditor::open_component(HalfedgeId h, FaceId face) {
  for (const HalfedgeId out : {h, h.twin()}) {
    unisolate(dcel_.origin(out));
    dcel_[dcel_.origin(out)].out = out;
  }
  dcel_.link(h, h.twin());
  dcel_.link(h.twin(), h);
  const BoundaryId boundary = new_boundary(h, face, false);
  dcel_[h].boundary = boundary;
  dcel_[h.twin()].boundary = boundary;
}

/// `out` leaves a vertex with edges and ends at an isolated one.
void LocalEditor::hang_antenna(HalfedgeId out, HalfedgeId arriving) {
  const VertexId end = dcel_.target(out);
  unisolate(end);
  dcel_[end].out = out.twin();
  dcel_.link(out.twin(), dcel_.next(arriving));
  dcel_.link(out, out.twin());
  dcel_.link(arriving, out);
  dcel_[out].boundary = dcel_[arriving].boundary;
  dcel_[out.twin()].boundary = dcel_[arriving].boundary;
}

HalfedgeId LocalEditor::link_between(HalfedgeId h, const RingPlace& left, const RingPlace& right) {
  const HalfedgeId after_left = dcel_.next(left.arriving);
  const HalfedgeId after_right = dcel_.next(right.arriving);
  dcel_.link(left.arriving, h);
  dcel_.link(h, after_right);
  dcel_.link(right.arriving, h.twin());
  dcel_.link(h.twin(), after_left);
  return h;
}

void LocalEditor::join_boundaries(HalfedgeId h, const RingPlace& left, const RingPlace& right) {
  BoundaryId kept = dcel_[left.arriving].boundary;
  BoundaryId gone = dcel_[right.arriving].boundary;
  if (dcel_[gone].is_outer && !dcel_[kept].is_outer) std::swap(kept, gone);
  kill(gone);
  link_between(h, left, right);
  relabel(h, kept);
}

/// The old face keeps the boundary that is like its old one.
void LocalEditor::split_face(HalfedgeId h, const RingPlace& left, const RingPlace& right) {
  const BoundaryId old_boundary = dcel_[left.arriving].boundary;
  const FaceId old_face = dcel_[old_boundary].face;
  link_between(h, left, right);
  const bool was_outer = dcel_[old_boundary].is_outer;
  const HalfedgeId created = was_outer || geometry_.is_outer(h.twin()) ? h.twin() : h;
  const HalfedgeId kept = created.twin();
  const FaceId new_face(dcel_.faces.size());
  dcel_.faces.emplace_back();
  const BoundaryId boundary = new_boundary(created, new_face, true);
  dcel_[kept].boundary = old_boundary;
  dcel_[old_boundary].halfedge = kept;
  relabel(created, boundary);
  if (was_outer && dcel_[old_face].is_unbounded) {
    dcel_[new_face].is_unbounded = has_fictitious_edge(created);
    dcel_[old_face].is_unbounded = has_fictitious_edge(kept);
    if (dcel_.base_face == old_face) dcel_.base_face = dcel_.face(dcel_[frame_corner()].out);
  }
  observers_.tell(&Observer::after_create_edge, h.edge());
  observers_.tell(&Observer::after_split_face, old_face, new_face);
  move_into_new_face(old_face, new_face, created);
}

/// Both cycles of the split are of one component; what else the old face holds is on one side or the other.
void LocalEditor::move_into_new_face(FaceId from, FaceId to, HalfedgeId cycle) {
  const BoundaryId sibling = dcel_[cycle.twin()].boundary;
  for (BoundaryId b = dcel_[from].first_boundary; !b.is_none();) {
    const BoundaryId next = dcel_[b].next;
    const bool is_around = is_planar_ && dcel_[b].is_outer;
    if (b != sibling && !is_around && geometry_.contains(cycle, dcel_.origin(dcel_[b].halfedge))) {
      observers_.tell(&Observer::before_move_boundary, b, from, to);
      unlist(b);
      list(b, to);
      observers_.tell(&Observer::after_move_boundary, b, from, to);
    }
    b = next;
  }
  for (VertexId v = dcel_[from].first_isolated; !v.is_none();) {
    const VertexId next = dcel_[v].next_isolated;
    if (geometry_.contains(cycle, v)) {
      observers_.tell(&Observer::before_move_isolated, v, from, to);
      unisolate(v);
      isolate(v, to);
      observers_.tell(&Observer::after_move_isolated, v, from, to);
    }
    v = next;
  }
}

VertexId LocalEditor::split_edge(EdgeId e) {
  observers_.tell(&Observer::before_split_edge, e);
  const CellState state = dcel_.edges[e.index()];
  const HalfedgeId h(e, false);
  const VertexId right = dcel_.target(h);
  const VertexId middle(dcel_.vertices.size());
  dcel_.vertices.emplace_back().state = state;
  const HalfedgeId r(new_edge(middle, right, state), false);
  dcel_[r].boundary = dcel_[h].boundary;
  dcel_[r.twin()].boundary = dcel_[h.twin()].boundary;
  const HalfedgeId after = dcel_.next(h);
  const HalfedgeId before = dcel_.previous(h.twin());
  if (after == h.twin()) {
    dcel_.link(r, r.twin());
  } else {
    dcel_.link(r, after);
    dcel_.link(before, r.twin());
  }
  dcel_.link(h, r);
  dcel_.link(r.twin(), h.twin());
  dcel_[h.twin()].origin = middle;
  dcel_[middle].out = r;
  if (dcel_[right].out == h.twin()) dcel_[right].out = r.twin();
  observers_.tell(&Observer::after_split_edge, e, middle, r.edge());
  return middle;
}

EdgeId LocalEditor::merge_edges(VertexId v) {
  const HalfedgeId out = dcel_[v].out;
  if (out.is_none() || dcel_.degree(v) != 2 || out.is_forward() == dcel_.clockwise(out).is_forward()) {
    throw InputError("edges at vertex " + std::to_string(v.value) + " are not two that follow each other");
  }
  const HalfedgeId r = out.is_forward() ? out : dcel_.clockwise(out);
  const HalfedgeId h = dcel_.previous(r);
  const EdgeId kept = h.edge();
  const EdgeId gone = r.edge();
  observers_.tell(&Observer::before_merge_edges, kept, v, gone);
  const VertexId right = dcel_.target(r);
  const HalfedgeId after = dcel_.next(r);
  if (after == r.twin()) {
    dcel_.link(h, h.twin());
  } else {
    const HalfedgeId before = dcel_.previous(r.twin());
    dcel_.link(h, after);
    dcel_.link(before, h.twin());
  }
  dcel_[h.twin()].origin = right;
  if (dcel_[right].out == r.twin()) dcel_[right].out = h.twin();
  for (const HalfedgeId side : {h, h.twin()}) dcel_[dcel_[side].boundary].halfedge = side;
  dcel_.edges[gone.index()] = CellState::dead;
  dcel_[v] = Vertex{HalfedgeId(), FaceId(), VertexId(), CellState::dead};
  observers_.tell(&Observer::after_merge_edges, kept, v, gone);
  return kept;
}

}  // namespace quoin::dcel
