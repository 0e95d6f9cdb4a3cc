// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/square_grades.h"
#include "quoin/flow/critical_spheres.h"
#include "quoin/flow/flow_graph.h"

namespace quoin::cli {

/// A critical point of index 1, by one of its simplices.
struct CriticalEdge {
  std::uint32_t cell = 0;
  unsigned edge = 0;
};

/// The squared distances at critical points of space as grades, in exact order. Grade 0 is that of the points
/// themselves.
class FlowGrades {
 public:
  /// The graph must outlive it. O(n log n) comparisons. @throws Cancelled
  FlowGrades(const FlowGraph& graph, const Context& context);
  FlowGrades(const FlowGrades&) = delete;
  FlowGrades& operator=(const FlowGrades&) = delete;

  /// In the order in which FlowCells visits them.
  std::span<const CriticalEdge> edges() const { return edges_; }
  /// Edges by ascending distance, and saddles of the graph; ties by number.
  std::span<const std::uint32_t> edges_in_order() const { return edges_in_order_; }
  std::span<const std::uint32_t> saddles_in_order() const { return saddles_in_order_; }

  std::uint32_t count() const { return grades_.count(); }
  /// As SquareGrades has it.
  double square(std::uint32_t grade) const { return grades_.square(grade); }
  std::uint32_t of_edge(std::uint32_t i) const { return grades_.of(i); }
  std::uint32_t of_saddle(std::uint32_t i) const { return grades_.of(first_saddle() + i); }
  std::uint32_t of_maximum(std::uint32_t i) const { return grades_.of(first_maximum() + i); }

  /// How many grades are at most this. Exact. O(log n)
  std::uint32_t up_to(const Rational& square) const { return grades_.up_to(square); }

 private:
  std::uint32_t first_saddle() const { return static_cast<std::uint32_t>(edges_.size()); }
  std::uint32_t first_maximum() const { return first_saddle() + static_cast<std::uint32_t>(graph_.saddles().size()); }
  SquareList squares() const;
  Interval bounds(std::uint32_t i) const;
  CriticalFace face(std::uint32_t i) const;

  const FlowGraph& graph_;
  CriticalValues values_;
  CriticalSpheres spheres_;
  std::vector<CriticalEdge> edges_;
  SquareGrades grades_;  // of edges, saddles, maxima
  std::vector<std::uint32_t> edges_in_order_;
  std::vector<std::uint32_t> saddles_in_order_;
};

}  // namespace quoin::cli
