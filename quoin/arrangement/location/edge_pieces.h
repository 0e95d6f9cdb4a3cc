// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/arrangement/location/edge_order.h"
#include "quoin/arrangement/sweep/sweep.h"

namespace quoin {

/// The edges of an arrangement as pieces for another sweep, and which cells they are.
template <CurveFamily F>
struct EdgePieces {
  PieceList<F> list;
  std::vector<dcel::EdgeId> edges;        ///< by piece
  std::vector<dcel::VertexId> vertices;   ///< by point of the list
  std::vector<dcel::VertexId> copies;     ///< of the left copies that a sweep adds, in its order
  std::vector<std::uint32_t> one_colour;  ///< by piece, all the same: edges do not cross

  /// The vertex of an input point of an event; `query_count` queries were given to the sweep. None for queries.
  dcel::VertexId vertex(std::uint32_t known, std::size_t query_count) const {
    if (known < vertices.size()) return vertices[known];
    const std::size_t rest = known - vertices.size();
    return rest < query_count ? dcel::VertexId() : copies[rest - query_count];
  }
};

/// All real edges and all vertices that have a point, ends at infinity too. Piece k is also curve k. Linear.
template <CurveFamily F>
EdgePieces<F> pieces_of(const Arrangement<F>& a) {
  EdgePieces<F> result;
  PieceList<F>& list = result.list;
  std::vector<std::uint32_t> point_of(a.vertex_count(), 0);
  const auto add = [&](dcel::VertexId v, const typename F::Point& point) {
    result.vertices.push_back(v);
    if (a.family().side(point) == Side::right) result.copies.push_back(v);
    return list.add_point(point);
  };
  for (std::size_t i = 0; i < a.vertex_count(); ++i) {
    const dcel::VertexId v(i);
    if (!is_point_vertex(a, v)) continue;
    point_of[i] = add(v, a.point(v));
    if (a.cells().is_isolated(v)) list.lone_points.push_back({point_of[i], CurveId(std::size_t{0})});
  }
  for (std::size_t i = 0; i < a.edge_count(); ++i) {
    const dcel::EdgeId e(i);
    if (!a.cells().is_real(e)) continue;
    Piece piece{a.branch(e), point_of[a.left(e).index()], point_of[a.right(e).index()], CurveId(list.pieces.size()),
                false};
    if constexpr (IdentifiedFamily<F>) {
      piece.left = add(a.left(e), a.left_point(e));
      piece.right = add(a.right(e), a.right_point(e));
    }
    list.pieces.push_back(piece);
    result.edges.push_back(e);
  }
  list.curve_count = static_cast<std::uint32_t>(list.pieces.size());
  result.one_colour.assign(list.pieces.size(), 0);
  return result;
}

/// Names the edges of a sweep over `pieces`: its edges start in an order of their own.
template <CurveFamily F>
class EdgeNames {
 public:
  explicit EdgeNames(const EdgePieces<F>& pieces) : pieces_(pieces) {}
  /// To be called for every event.
  void follow(const SweepEvent<typename F::Point>& event) {
    for (const std::uint32_t piece : event.bundles) names_.push_back(pieces_.edges[piece]);
  }
  dcel::EdgeId operator[](std::uint32_t edge) const {
    return edge == SweepStatus::none ? dcel::EdgeId() : names_[edge];
  }
  /// The vertex of an event; none if it is only of queries.
  dcel::VertexId vertex(const SweepEvent<typename F::Point>& event, std::size_t query_count) const {
    for (const std::uint32_t index : event.known) {
      const dcel::VertexId v = pieces_.vertex(index, query_count);
      if (!v.is_none()) return v;
    }
    return {};
  }

 private:
  const EdgePieces<F>& pieces_;
  std::vector<dcel::EdgeId> names_;
};

}  // namespace quoin
