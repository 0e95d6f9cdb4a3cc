// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "quoin/arrangement/edit/local_edits.h"
#include "quoin/base/error.h"

/// The frame of fictitious edges that closes the unbounded plane. Its halfedges run counterclockwise with the plane on
/// their left; its corners keep the order bottom left, bottom right, top right, top left of their ids.
namespace quoin::dcel {

using Observer = ArrangementObserver;

/// A corner has two edges, an end of a curve a third one.
VertexId LocalEditor::frame_corner() const {
  VertexId first;
  std::size_t corners = 0;
  for (std::size_t i = dcel_.vertices.size(); i-- > 0 && corners < 4;) {
    const Vertex& vertex = dcel_.vertices[i];
    if (vertex.state != CellState::fictitious || dcel_.degree(VertexId(i)) != 2) continue;
    first = VertexId(i);
    ++corners;
  }
  return corners == 4 ? first : VertexId();
}

void LocalEditor::add_frame() {
  if (has_frame()) throw InputError("the plane has a frame already");
  const FaceId inside = dcel_.base_face;
  if (!dcel_[inside].is_unbounded) throw InputError("a surface without an unbounded face has no frame");
  observers_.tell(&Observer::before_change_frame);
  const std::size_t corner = dcel_.vertices.size();
  std::array<HalfedgeId, 4> sides;
  for (std::size_t i = 0; i < 4; ++i) dcel_.vertices.emplace_back().state = CellState::fictitious;
  for (std::size_t i = 0; i < 4; ++i) {
    sides[i] = HalfedgeId(new_edge(VertexId(corner + i), VertexId(corner + (i + 1) % 4), CellState::fictitious), false);
    dcel_.vertices[corner + i].out = sides[i];
  }
  const FaceId outside(dcel_.faces.size());
  dcel_.faces.emplace_back().state = CellState::fictitious;
  for (std::size_t i = 0; i < 4; ++i) {
    dcel_.link(sides[i], sides[(i + 1) % 4]);
    dcel_.link(sides[(i + 1) % 4].twin(), sides[i].twin());
  }
  relabel(sides[0], new_boundary(sides[0], inside, true));
  relabel(sides[0].twin(), new_boundary(sides[0].twin(), outside, true));
  observers_.tell(&Observer::after_change_frame);
}

void LocalEditor::remove_frame_end(VertexId v) {
  const EdgeId merged = merge_edges(v);
  const HalfedgeId h(merged, false);
  if (is_bare_frame(h)) remove_frame(h);
}

bool LocalEditor::is_bare_frame(HalfedgeId start) const {
  HalfedgeId h = start;
  for (int i = 0; i < 4; ++i) {
    if (dcel_.edges[h.edge().index()] != CellState::fictitious) return false;
    h = dcel_.next(h);
  }
  return h == start;
}

void LocalEditor::remove_frame(HalfedgeId start) {
  observers_.tell(&Observer::before_change_frame);
  const BoundaryId outside = dcel_[start.twin()].boundary;
  const FaceId outer_face = dcel_[outside].face;
  kill(dcel_[start].boundary);
  kill(outside);
  dcel_[outer_face] = Face{BoundaryId(), VertexId(), false, CellState::dead};
  HalfedgeId h = start;
  for (int i = 0; i < 4; ++i) {
    dcel_[dcel_.origin(h)] = Vertex{HalfedgeId(), FaceId(), VertexId(), CellState::dead};
    dcel_.edges[h.edge().index()] = CellState::dead;
    h = dcel_.next(h);
  }
  observers_.tell(&Observer::after_change_frame);
}

}  // namespace quoin::dcel
