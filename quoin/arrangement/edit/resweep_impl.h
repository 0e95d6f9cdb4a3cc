// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "quoin/arrangement/arrangement_impl.h"
#include "quoin/arrangement/edit/arrangement_editor_impl.h"
#include "quoin/arrangement/edit/cell_tracing.h"
#include "quoin/arrangement/edit/insert.h"

/// Bodies of the operations that sweep an arrangement anew, for the one source file per family that instantiates them.
namespace quoin {

/// An arrangement as a list: every edge is a piece, and the "curve" of a piece is its number. New pieces follow.
template <CurveFamily F>
struct ResweepList {
  PieceList<F> list;
  std::vector<std::uint32_t> colours;
  std::vector<dcel::EdgeId> edge_of_piece;     // of the old pieces
  std::vector<CurveUse> use_of_piece;          // of the new pieces
  std::vector<std::uint32_t> point_of_vertex;  // of real and infinite old vertices
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  explicit ResweepList(const Arrangement<F>& arrangement);
  void append(const PieceList<F>& more, const typename F::Shift& shift, CurveId first);

 private:
  void add(BranchId branch, std::uint32_t left, std::uint32_t right, std::uint32_t colour) {
    list.pieces.push_back({branch, left, right, CurveId(list.pieces.size()), false});
    colours.push_back(colour);
  }
};

template <CurveFamily F>
ResweepList<F>::ResweepList(const Arrangement<F>& arrangement)
    : point_of_vertex(arrangement.vertex_count(), std::uint32_t{none}) {
  const dcel::Dcel& cells = arrangement.cells();
  for (std::size_t i = 0; i < cells.edges.size(); ++i) {
    const dcel::EdgeId e(i);
    if (!cells.is_real(e)) continue;
    // Ends of one vertex may be different copies of its point.
    const std::uint32_t left = list.add_point(arrangement.left_point(e));
    const std::uint32_t right = list.add_point(arrangement.right_point(e));
    point_of_vertex[arrangement.left(e).index()] = left;
    point_of_vertex[arrangement.right(e).index()] = right;
    add(arrangement.branch(e), left, right, 0);
    edge_of_piece.push_back(e);
  }
  for (std::size_t i = 0; i < cells.vertices.size(); ++i) {
    const dcel::VertexId v(i);
    if (!cells.is_real(v) || !cells.is_isolated(v)) continue;
    point_of_vertex[i] = list.add_point(arrangement.point(v));
    list.lone_points.push_back({point_of_vertex[i], CurveId()});
  }
}

template <CurveFamily F>
void ResweepList<F>::append(const PieceList<F>& more, const typename F::Shift& shift, CurveId first) {
  const auto begin = static_cast<std::uint32_t>(list.points.size());
  for (const auto& point : more.points) list.points.push_back(F::shifted(point, shift));
  for (std::size_t i = 0; i < more.pieces.size(); ++i) {
    const Piece& piece = more.pieces[i];
    add(F::shifted(piece.branch, shift), begin + piece.left, begin + piece.right, static_cast<std::uint32_t>(i + 1));
    use_of_piece.emplace_back(CurveId(first.index() + piece.curve.index()), piece.reversed);
  }
  for (const LonePoint& lone : more.lone_points) list.lone_points.push_back({begin + lone.point, CurveId()});
}

/// The history of the result by curves, and the old edges of its edges.
template <CurveFamily F>
CurveHistory trace_edges(const Arrangement<F>& old, const Arrangement<F>& result, const ResweepList<F>& input,
                         CellMap& map) {
  CurveHistory history;
  std::vector<CurveUse> uses;
  map.old_edge.resize(result.edge_count());
  map.new_edge.resize(old.edge_count());
  const std::size_t old_pieces = input.edge_of_piece.size();
  for (std::size_t i = 0; i < result.edge_count(); ++i) {
    uses.clear();
    for (const CurveUse use : result.curves(dcel::EdgeId(i))) {
      const std::size_t piece = use.curve().index();
      if (piece >= old_pieces) {
        uses.push_back(input.use_of_piece[piece - old_pieces]);
        continue;
      }
      const dcel::EdgeId from = input.edge_of_piece[piece];
      map.old_edge[i] = from;
      if (map.new_edge[from.index()].is_none()) map.new_edge[from.index()] = dcel::EdgeId(i);
      const auto curves = old.curves(from);
      uses.insert(uses.end(), curves.begin(), curves.end());
    }
    std::sort(uses.begin(), uses.end());
    history.append(uses);
  }
  return history;
}

template <CurveFamily F>
CellMap resweep(Arrangement<F>& arrangement, F family, const ResweepList<F>& input, std::uint32_t curve_count,
                const Context& context) {
  BuildVisitor<F> visitor(family, input.list);
  const SweepOptions options{input.colours};
  Sweep<F>(family, input.list, {}, options, visitor, context).run();
  Arrangement<F> result = visitor.finish(std::move(family));
  CellMap map;
  CurveHistory history = trace_edges(arrangement, result, input, map);
  map.new_vertex.resize(arrangement.vertex_count());
  map.old_vertex.resize(result.vertex_count());
  for (std::size_t i = 0; i < input.point_of_vertex.size(); ++i) {
    if (input.point_of_vertex[i] == input.none) continue;
    map.new_vertex[i] = visitor.vertex_of_point()[input.point_of_vertex[i]];
    map.old_vertex[map.new_vertex[i].index()] = dcel::VertexId(i);
  }
  dcel::trace_faces(arrangement.cells(), result.cells(), map);
  result.set_history(std::move(history), curve_count);
  ArrangementEditor<F>(arrangement).replace(std::move(result), map);
  return map;
}

template <CurveFamily F>
CurveId insert_many(Arrangement<F>& arrangement, const F& family, const PieceList<F>& list, const Context& context) {
  F merged = arrangement.family();
  const auto shift = merged.absorb(family);
  const CurveId first(std::size_t{arrangement.curve_count()});
  ResweepList<F> input(arrangement);
  input.append(list, shift, first);
  resweep(arrangement, std::move(merged), input, arrangement.curve_count() + list.curve_count, context);
  return first;
}

template <CurveFamily F>
CellMap renumber(Arrangement<F>& arrangement, const Context& context) {
  F family = arrangement.family();
  return resweep(arrangement, std::move(family), ResweepList<F>(arrangement), arrangement.curve_count(), context);
}

}  // namespace quoin
