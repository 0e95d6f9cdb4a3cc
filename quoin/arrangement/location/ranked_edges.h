// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "quoin/arrangement/location/edge_order.h"
#include "quoin/arrangement/sweep/sweep_points.h"

namespace quoin {

/// The edges of an arrangement with their ends numbered in lexicographic order, so that ends compare as integers.
///
/// On a sphere both copies of a point on the identification have ranks, and every meridian has its own end at a pole.
template <class Point>
struct RankedEdges {
  struct Edge {
    std::uint32_t left;
    std::uint32_t right;
    BranchId branch;
    dcel::EdgeId id;
  };
  std::vector<Point> points;             ///< by rank
  std::vector<dcel::VertexId> vertices;  ///< by rank; several ranks may be one vertex
  std::vector<Edge> edges;               ///< real ones
  std::vector<std::uint32_t> lone;       ///< ranks at which no edge ends
};

/// O(n log n); linear if vertices are still in order.
template <CurveFamily F>
RankedEdges<typename F::Point> ranked_edges(const Arrangement<F>& a, const Context& context) {
  using Point = typename F::Point;
  std::vector<Point> points;
  std::vector<dcel::VertexId> vertices;
  std::vector<std::uint32_t> place_of_vertex(a.vertex_count(), dcel::VertexId::none_value);
  for (std::size_t i = 0; i < a.vertex_count(); ++i) {
    const dcel::VertexId v(i);
    if (!is_point_vertex(a, v)) continue;
    place_of_vertex[i] = static_cast<std::uint32_t>(points.size());
    points.push_back(a.point(v));
    vertices.push_back(v);
  }
  RankedEdges<Point> result;
  const auto place_of_end = [&](dcel::VertexId v, const Point& end) {
    if constexpr (IdentifiedFamily<F>) {
      points.push_back(end);
      vertices.push_back(v);
      return static_cast<std::uint32_t>(points.size() - 1);
    }
    static_cast<void>(end);
    return place_of_vertex[v.index()];
  };
  for (std::size_t i = 0; i < a.edge_count(); ++i) {
    const dcel::EdgeId e(i);
    if (!a.cells().is_real(e)) continue;
    const std::uint32_t left = place_of_end(a.left(e), a.left_point(e));
    const std::uint32_t right = place_of_end(a.right(e), a.right_point(e));
    result.edges.push_back({left, right, a.branch(e), e});
  }
  const std::vector<std::uint32_t> order = sorted_points(context, a.family(), std::span<const Point>(points));
  std::vector<std::uint32_t> rank(points.size());
  for (const std::uint32_t place : order) {
    const bool is_new =
        result.points.empty() || a.family().compare_xy(result.points.back(), points[place]) != Sign::zero;
    if (is_new) {
      result.points.push_back(points[place]);
      result.vertices.push_back(vertices[place]);
    }
    rank[place] = static_cast<std::uint32_t>(result.points.size() - 1);
  }
  std::vector<bool> is_end(result.points.size(), false);
  for (auto& edge : result.edges) {
    edge.left = rank[edge.left];
    edge.right = rank[edge.right];
    is_end[edge.left] = is_end[edge.right] = true;
  }
  for (std::uint32_t r = 0; r < is_end.size(); ++r) {
    if (!is_end[r]) result.lone.push_back(r);
  }
  return result;
}

}  // namespace quoin
