// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/flow_graph.h"

namespace quoin::cli {

/// A critical point of index 1, by one of its simplices.
struct CriticalEdge {
  std::uint32_t cell = 0;
  unsigned edge = 0;
};

/// The squared distances at critical points of space, ascending, as grades: equal ones are one grade. Grade 0 is that
/// of the points themselves. The order is exact; doubles with bounds tell most of it.
class FlowGrades {
 public:
  /// The graph must outlive it. O(n log n) comparisons. @throws Cancelled
  FlowGrades(const FlowGraph& graph, const Context& context);

  /// In the order in which FlowCells visits them.
  std::span<const CriticalEdge> edges() const { return edges_; }
  /// Edges by ascending distance, and saddles of the graph; ties by number.
  std::span<const std::uint32_t> edges_in_order() const { return edges_in_order_; }
  std::span<const std::uint32_t> saddles_in_order() const { return saddles_in_order_; }

  std::uint32_t count() const { return static_cast<std::uint32_t>(squares_.size()); }
  /// Up to a few units in the last place; infinite beyond the largest double. Never descending.
  double square(std::uint32_t grade) const { return squares_[grade]; }
  std::uint32_t of_edge(std::uint32_t i) const { return grade_[i]; }
  std::uint32_t of_saddle(std::uint32_t i) const { return grade_[first_saddle() + i]; }
  std::uint32_t of_maximum(std::uint32_t i) const { return grade_[first_maximum() + i]; }

  /// How many grades are at most this. Exact. O(log n)
  std::uint32_t up_to(const Rational& square) const;

 private:
  std::uint32_t first_saddle() const { return static_cast<std::uint32_t>(edges_.size()); }
  std::uint32_t first_maximum() const { return first_saddle() + static_cast<std::uint32_t>(graph_.saddles().size()); }
  Interval bounds(std::uint32_t i) const;
  Rational exact(std::uint32_t i) const;
  void add_group(std::span<const std::uint32_t> group, std::span<const Interval> squares, const Context& context);
  void add_grade(double square, std::uint32_t example);

  const FlowGraph& graph_;
  CriticalValues values_;
  std::vector<CriticalEdge> edges_;
  std::vector<std::uint32_t> edges_in_order_;
  std::vector<std::uint32_t> saddles_in_order_;
  std::vector<std::uint32_t> grade_;    // of edges, saddles, maxima
  std::vector<double> squares_{0};      // by grade
  std::vector<std::uint32_t> example_;  // by grade but the first: a critical point that has it
};

}  // namespace quoin::cli
