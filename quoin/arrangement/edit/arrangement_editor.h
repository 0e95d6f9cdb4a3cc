// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "quoin/arrangement/arrangement.h"
#include "quoin/arrangement/edit/cell_geometry.h"
#include "quoin/arrangement/edit/local_edits.h"

namespace quoin {

/// A piece to be inserted that meets nothing of the arrangement but at its ends.
struct NewEdge {
  BranchId branch;                   ///< of the arrangement's family
  std::span<const CurveUse> curves;  ///< that run along it, sorted
};

/// Local edits of an arrangement: pieces that are known to cross nothing, vertices, splits, merges, removals.
///
/// Links, points, branches and history change together, and observers are told. What is stated of the arguments is
/// taken on trust where checking needs a search; what can be seen at the place itself is checked. After an InputError
/// nothing has changed. On a surface with glued or contracted sides only splits, merges and removals away from those
/// sides are supported; `insert_many` works everywhere.
template <CurveFamily F>
class ArrangementEditor {
 public:
  using Point = typename F::Point;
  static constexpr bool is_planar = F::Surface::has_unbounded_face;

  explicit ArrangementEditor(Arrangement<F>& arrangement)
      : a_(arrangement), geometry_(arrangement), local_(a_.cells_, geometry_, a_.observers_, is_planar) {}

  const Arrangement<F>& arrangement() const { return a_; }
  const CellGeometry<F>& geometry() const { return geometry_; }
  /// To add supports.
  F& family() { return a_.family_; }
  /// Room for new curves in the history; the first of them.
  CurveId add_curves(std::uint32_t count) {
    a_.curve_count_ += count;
    return CurveId(std::size_t{a_.curve_count_ - count});
  }

  // Vertices.

  /// An isolated vertex inside a face.
  dcel::VertexId insert_vertex(const Point& point, dcel::FaceId face);
  /// @throws InputError if it is not isolated
  void remove_vertex(dcel::VertexId v);

  // Edges. `hint`, if not none, is the halfedge that arrives at the vertex and that the new edge follows.

  /// Neither end is a vertex yet, or is an end at infinity: a new component, or a curve through a framed face.
  dcel::EdgeId insert_in_face(const NewEdge& edge, const Point& left, const Point& right, dcel::FaceId face);
  dcel::EdgeId insert_from_left(const NewEdge& edge, dcel::VertexId left, const Point& right,
                                dcel::HalfedgeId hint = {});
  dcel::EdgeId insert_from_right(const NewEdge& edge, const Point& left, dcel::VertexId right,
                                 dcel::HalfedgeId hint = {});
  dcel::EdgeId insert_between(const NewEdge& edge, dcel::VertexId left, dcel::VertexId right,
                              dcel::HalfedgeId left_hint = {}, dcel::HalfedgeId right_hint = {});
  /// The point must lie on the edge, strictly between its ends. The left part keeps the id.
  dcel::VertexId split_edge(dcel::EdgeId e, const Point& point);
  /// Whether the two edges at the vertex are one piece of the same curves.
  bool can_merge(dcel::VertexId v) const;
  /// @throws InputError unless can_merge
  dcel::EdgeId merge_edges(dcel::VertexId v);
  void remove_edge(dcel::EdgeId e, const dcel::RemoveEdgeOptions& options = {});
  /// The curves that run along an edge, sorted.
  void set_curves(dcel::EdgeId e, std::span<const CurveUse> curves);
  void add_curve(dcel::EdgeId e, CurveUse use);

  /// Another arrangement takes the place of this one; observers are told once, with what became of the cells.
  void replace(Arrangement<F>&& other, const CellMap& map);

 private:
  dcel::RingPlace at_left_end(dcel::VertexId v, BranchId branch, dcel::HalfedgeId hint) const;
  dcel::RingPlace at_right_end(dcel::VertexId v, BranchId branch, dcel::HalfedgeId hint) const;
  void check_order(const Point& left, const Point& right) const;
  void check_new_end(const Point& end, dcel::FaceId face) const;
  void check_vertex(dcel::VertexId v) const;
  void check_edge(dcel::EdgeId e) const;
  void check_face(dcel::FaceId face) const;
  void check_hint(dcel::VertexId v, dcel::HalfedgeId hint) const;
  static void check_planar();
  dcel::RingPlace new_end(const Point& end, dcel::FaceId face);
  dcel::RingPlace new_infinite_end(const Point& end);
  dcel::HalfedgeId frame_arriving(dcel::VertexId end) const;
  dcel::VertexId split(dcel::EdgeId e, const Point& point);
  dcel::EdgeId link(const NewEdge& edge, const dcel::RingPlace& left, const dcel::RingPlace& right);
  void fill_columns();
  void set_ends(dcel::EdgeId e, const Point& left, const Point& right);

  Arrangement<F>& a_;
  CellGeometry<F> geometry_;
  dcel::LocalEditor local_;
};

}  // namespace quoin
