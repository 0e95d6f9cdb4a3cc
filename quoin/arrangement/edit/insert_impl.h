// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/edit/arrangement_editor_impl.h"
#include "quoin/arrangement/edit/insert.h"
#include "quoin/arrangement/edit/resweep_impl.h"
#include "quoin/arrangement/edit/zone_impl.h"

/// Bodies of insertion and removal of curves, for the one source file per family that instantiates them.
namespace quoin {

/// Inserts a piece step by step.
template <CurveFamily F>
class ZoneInserter : public ZoneVisitor<typename F::Point> {
 public:
  using Step = ZoneStep<typename F::Point>;

  ZoneInserter(ArrangementEditor<F>& editor, BranchId branch, CurveUse use)
      : editor_(editor), branch_(branch), use_(use) {}

  std::optional<Location> at_step(const Step& step) override {
    const dcel::VertexId left = vertex_at(step.at_left, step.left);
    if (!step.overlapped.is_none()) return run_along(left, step);
    // A curve may start on an edge and come back to it: then it comes back to what is now the right part.
    const bool comes_back = step.at_left.is_edge() && step.at_left == step.at_right;
    const dcel::VertexId right = comes_back
                                     ? editor_.split_edge(editor_.arrangement().cells()[left].out.edge(), step.right)
                                     : vertex_at(step.at_right, step.right);
    const NewEdge edge{branch_, {&use_, 1}};
    dcel::EdgeId created;
    if (left.is_none()) {
      created = right.is_none() ? editor_.insert_in_face(edge, step.left, step.right, step.face)
                                : editor_.insert_from_right(edge, step.left, right);
    } else {
      created = right.is_none() ? editor_.insert_from_left(edge, left, step.right)
                                : editor_.insert_between(edge, left, right);
    }
    return editor_.arrangement().right(created);
  }

 private:
  /// None in a face.
  dcel::VertexId vertex_at(const Location& cell, const typename F::Point& p) {
    return cell.is_edge() ? editor_.split_edge(cell.edge(), p) : cell.vertex();
  }
  std::optional<Location> run_along(dcel::VertexId left, const Step& step) {
    const dcel::EdgeId edge = editor_.geometry().place_right(left, branch_).overlapped;
    if (step.at_right.is_edge()) editor_.split_edge(edge, step.right);
    editor_.add_curve(edge, use_);
    return editor_.arrangement().right(edge);
  }

  ArrangementEditor<F>& editor_;
  BranchId branch_;
  CurveUse use_;
};

template <CurveFamily F>
void insert_point(ArrangementEditor<F>& editor, const typename F::Point& point,
                  const ZoneLocator<typename F::Point>& locate) {
  const Location cell = locate ? locate(point) : NaiveLocator<F>(editor.arrangement()).locate(point);
  if (cell.is_edge()) editor.split_edge(cell.edge(), point);
  if (cell.is_face()) editor.insert_vertex(point, cell.face());
}

template <CurveFamily F>
CurveId insert(Arrangement<F>& arrangement, const F& family, const PieceList<F>& list, const Context& context,
               const InsertOptions<typename F::Point>& options) {
  if (!F::Surface::has_unbounded_face || list.pieces.size() + list.lone_points.size() >= options.sweeps_from) {
    return insert_many(arrangement, family, list, context);
  }
  ArrangementEditor<F> editor(arrangement);
  const auto shift = editor.family().absorb(&family == &editor.family() ? F(family) : family);
  const CurveId first = editor.add_curves(list.curve_count);
  for (const Piece& piece : list.pieces) {
    context.poll();
    const BranchId branch = F::shifted(piece.branch, shift);
    ZoneInserter<F> inserter(editor, branch, CurveUse(CurveId(first.index() + piece.curve.index()), piece.reversed));
    const ZonePiece<typename F::Point> path{branch, F::shifted(list.points[piece.left], shift),
                                            F::shifted(list.points[piece.right], shift)};
    zone(arrangement, path, inserter, options.locate);
  }
  for (const LonePoint& lone : list.lone_points) {
    insert_point(editor, F::shifted(list.points[lone.point], shift), options.locate);
  }
  return first;
}

template <CurveFamily F>
void remove_curve(Arrangement<F>& arrangement, CurveId curve, const RemoveCurveOptions& options) {
  if (curve.index() >= arrangement.curve_count()) {
    throw InputError("there is no curve " + std::to_string(curve.value));
  }
  ArrangementEditor<F> editor(arrangement);
  std::vector<dcel::VertexId> touched;
  const auto edges = arrangement.history().edges_by_curve(arrangement.curve_count());
  for (const dcel::EdgeId e : edges[curve.index()]) {
    if (!arrangement.cells().is_real(e)) continue;  // listed twice: the curve runs along it twice
    touched.push_back(arrangement.left(e));
    touched.push_back(arrangement.right(e));
    std::vector<CurveUse> others;
    for (const CurveUse use : arrangement.curves(e)) {
      if (use.curve() != curve) others.push_back(use);
    }
    if (others.empty()) {
      editor.remove_edge(e);
    } else {
      editor.set_curves(e, others);
    }
  }
  if (!options.merges_edges) return;
  for (const dcel::VertexId v : touched) {
    if (editor.can_merge(v)) editor.merge_edges(v);
  }
}

}  // namespace quoin
