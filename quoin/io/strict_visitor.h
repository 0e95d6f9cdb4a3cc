// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "quoin/arrangement/sweep/build_visitor.h"
#include "quoin/io/exact_lines.h"

namespace quoin::io {

/// Vertices and edges of a text, as a list for a sweep: piece k is edge k.
template <CurveFamily F>
struct TextCells {
  F family;
  PieceList<F> list;
  std::vector<std::uint32_t> vertex_of_point;  ///< by point of the list
  std::vector<std::vector<CurveUse>> uses;     ///< by edge
  std::vector<std::size_t> vertex_lines;
  std::vector<std::size_t> edge_lines;
  std::vector<std::uint32_t> left_vertices;  ///< by edge
};

inline std::string named(const char* kind, std::size_t index) {
  return kind + std::to_string(index);
}

[[noreturn]] inline void refuse_repeated(const ExactLines& lines, const std::vector<std::size_t>& vertex_lines,
                                         std::uint32_t a, std::uint32_t b) {
  lines.fail_at(vertex_lines[std::max(a, b)],
                named("vertex ", std::min(a, b)) + " and " + named("vertex ", std::max(a, b)) + " are the same point");
}

/// Builds, and refuses whatever the text does not say: other vertices and edges than its own, in its order.
template <CurveFamily F>
class StrictVisitor : public BuildVisitor<F> {
 public:
  using Point = typename F::Point;
  StrictVisitor(const TextCells<F>& cells, const ExactLines& lines)
      : BuildVisitor<F>(cells.family, cells.list), cells_(cells), lines_(lines) {}

  bool at_event(const SweepEvent<Point>& event) override {
    const std::uint32_t vertex = vertex_of(event);
    if (vertex == event.none) refuse_meeting(event);
    if (vertex > next_vertex_) refuse_order(vertex);
    next_vertex_ = std::max(next_vertex_, vertex + 1);
    for (std::size_t i = 0; i < event.bundles.size(); ++i) {
      const std::uint32_t edge = event.bundles[i];
      const std::uint32_t other = event.next_in_bundle[edge];
      if (other != event.none) {
        lines_.fail_at(cells_.edge_lines[edge], named("edge ", edge) + " overlaps " + named("edge ", other));
      }
      if (cells_.left_vertices[edge] != vertex) {
        lines_.fail_at(cells_.edge_lines[edge], named("edge ", edge) + " passes through " + named("vertex ", vertex));
      }
      if (edge != event.right[i]) {
        lines_.fail_at(cells_.edge_lines[edge], named("edge ", edge) + " is not where its order is: it is number " +
                                                    std::to_string(event.right[i]));
      }
    }
    return BuildVisitor<F>::at_event(event);
  }

 private:
  /// The text's vertex at the event; none at a crossing.
  std::uint32_t vertex_of(const SweepEvent<Point>& event) const {
    std::uint32_t vertex = event.none;
    for (const std::uint32_t index : event.known) {
      if (index >= cells_.vertex_of_point.size()) continue;
      const std::uint32_t here = cells_.vertex_of_point[index];
      if (vertex != event.none && here != vertex) {
        refuse_repeated(lines_, cells_.vertex_lines, here, vertex);
      }
      vertex = here;
    }
    return vertex;
  }

  [[noreturn]] void refuse_order(std::uint32_t vertex) const {
    lines_.fail_at(cells_.vertex_lines[vertex],
                   named("vertex ", vertex) + " is out of order: it lies before " + named("vertex ", next_vertex_));
  }

  [[noreturn]] void refuse_meeting(const SweepEvent<Point>& event) const {
    const std::uint32_t a = event.left.empty() ? 0 : event.left.front();
    const std::uint32_t b = event.left.empty() ? 0 : event.left.back();
    lines_.fail_at(cells_.edge_lines[std::max(a, b)], named("edge ", std::min(a, b)) + " and " +
                                                          named("edge ", std::max(a, b)) + " meet where no vertex is");
  }

  const TextCells<F>& cells_;
  const ExactLines& lines_;
  std::uint32_t next_vertex_ = 0;
};

}  // namespace quoin::io
