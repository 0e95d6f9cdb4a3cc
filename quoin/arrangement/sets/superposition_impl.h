// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/sets/superposition.h"
#include "quoin/arrangement/sweep/build_visitor.h"
#include "quoin/arrangement/sweep/sweep.h"

/// Bodies of superposition.h, for the one source file per family that instantiates it.
namespace quoin {

namespace superposition_detail {

template <CurveFamily F>
struct Gathered {
  F family;
  PieceList<F> list;
  std::vector<std::uint32_t> colours;
  std::vector<std::uint32_t> point_of_vertex;  // over all sources
};

template <CurveFamily F>
void gather(const Arrangement<F>& source, std::uint32_t colour, std::uint32_t first_edge, Gathered<F>& all) {
  const typename F::Shift shift = all.family.absorb(source.family());
  const auto first_vertex = static_cast<std::uint32_t>(all.point_of_vertex.size());
  const dcel::Dcel& cells = source.cells();
  for (std::size_t v = 0; v < source.vertex_count(); ++v) {
    const dcel::VertexId id(v);
    // Ends at infinity are points too; only the corners of the frame are not.
    const bool has_point = cells[id].state != dcel::CellState::dead && source.has_point(id);
    all.point_of_vertex.push_back(has_point ? all.list.add_point(F::shifted(source.point(id), shift))
                                            : SweepStatus::none);
    if (has_point && cells.is_real(id) && cells.is_isolated(id)) {
      all.list.lone_points.push_back({all.point_of_vertex.back(), CurveId()});
    }
  }
  for (std::size_t e = 0; e < source.edge_count(); ++e) {
    const dcel::EdgeId id(e);
    if (!cells.is_real(id)) continue;
    Piece piece{F::shifted(source.branch(id), shift), all.point_of_vertex[first_vertex + source.left(id).index()],
                all.point_of_vertex[first_vertex + source.right(id).index()], CurveId(std::size_t{first_edge} + e),
                false};
    if constexpr (F::Surface::sides.left == SideKind::identified) {
      piece.left = all.list.add_point(F::shifted(source.left_point(id), shift));
      piece.right = all.list.add_point(F::shifted(source.right_point(id), shift));
    }
    all.list.pieces.push_back(piece);
    all.colours.push_back(colour);
  }
}

}  // namespace superposition_detail

template <CurveFamily F>
Superposition<F> superpose(std::span<const Arrangement<F>* const> sources, const Context& context) {
  superposition_detail::Gathered<F> all;
  Superposition<F> result;
  result.first_edge.push_back(0);
  result.first_vertex.push_back(0);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    gather(*sources[i], static_cast<std::uint32_t>(i), result.first_edge.back(), all);
    result.first_edge.push_back(result.first_edge.back() + static_cast<std::uint32_t>(sources[i]->edge_count()));
    result.first_vertex.push_back(static_cast<std::uint32_t>(all.point_of_vertex.size()));
  }
  all.list.curve_count = result.first_edge.back();
  BuildVisitor<F> visitor(all.family, all.list);
  Sweep<F>(all.family, all.list, {}, {all.colours}, visitor, context).run();
  result.arrangement = visitor.finish(std::move(all.family));
  result.vertex_of_source.reserve(all.point_of_vertex.size());
  for (const std::uint32_t point : all.point_of_vertex) {
    result.vertex_of_source.push_back(point == SweepStatus::none ? dcel::VertexId() : visitor.vertex_of_point()[point]);
  }
  return result;
}

}  // namespace quoin
