// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/arrangement/location/location.h"

/// Predicates on the edges of an arrangement, which do not cross. "Above" and "below" a point are meant along the line
/// through it that leans a little to the left, so that it meets points of one x one after the other.
namespace quoin {

/// Vertex ids are live: not dead, and with a point.
template <CurveFamily F>
bool is_point_vertex(const Arrangement<F>& a, dcel::VertexId v) {
  return a.has_point(v) && a.cells()[v].state != dcel::CellState::dead;
}

/// Whether a leaning line through p meets the inside of the edge.
template <CurveFamily F>
bool spans(const Arrangement<F>& a, dcel::EdgeId e, const typename F::Point& p) {
  return a.family().compare_xy(a.left_point(e), p) == Sign::negative &&
         a.family().compare_xy(p, a.right_point(e)) == Sign::negative;
}

/// Order of two different edges where a leaning line meets both. Positive: e lies above f. Neither is vertical, or the
/// line meets them off their ends.
template <CurveFamily F>
Sign order_of_edges(const Arrangement<F>& a, dcel::EdgeId e, dcel::EdgeId f) {
  const F& family = a.family();
  const Sign first = family.compare_xy(a.left_point(e), a.left_point(f));
  if (first == Sign::zero) return family.compare_right(a.branch(e), a.branch(f), a.left_point(e));
  if (first == Sign::positive) return family.compare_y_at_x(a.left_point(e), a.branch(f));
  return -family.compare_y_at_x(a.left_point(f), a.branch(e));
}

/// The vertex if `p` is an end of the edge, else the edge; `p` lies on it.
template <CurveFamily F>
Location place_on_edge(const Arrangement<F>& a, dcel::EdgeId e, const typename F::Point& p) {
  if (a.family().compare_xy(p, a.left_point(e)) == Sign::zero) return a.left(e);
  if (a.family().compare_xy(p, a.right_point(e)) == Sign::zero) return a.right(e);
  return e;
}

template <CurveFamily F>
dcel::FaceId face_above(const Arrangement<F>& a, dcel::EdgeId e) {
  return a.cells().face(dcel::HalfedgeId(e, false));
}

template <CurveFamily F>
dcel::FaceId face_below(const Arrangement<F>& a, dcel::EdgeId e) {
  return a.cells().face(dcel::HalfedgeId(e, true));
}

/// Which of an edge and a vertex, each the next of its kind, a vertical ray meets first. One may be none.
template <VerticalFamily F>
Location first_met(const Arrangement<F>& a, Direction direction, dcel::EdgeId edge, dcel::VertexId vertex) {
  if (vertex.is_none()) return edge;
  if (edge.is_none()) return vertex;
  const Sign side = a.family().compare_y_at_x(a.point(vertex), a.branch(edge));
  const bool is_vertex_behind = side == (direction == Direction::up ? Sign::positive : Sign::negative);
  return is_vertex_behind ? Location(edge) : Location(vertex);
}

}  // namespace quoin
