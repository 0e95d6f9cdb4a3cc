// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "quoin/arrangement/location/ranked_edges.h"

namespace quoin {

/// A part of the parameter rectangle between two edges and two walls through points.
struct Trapezoid {
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  std::uint32_t top = none;     ///< index of a ranked edge; none: the rectangle's side
  std::uint32_t bottom = none;  ///< as `top`
  std::uint32_t left = none;    ///< rank of the point on the left wall, none if it reaches the side
  std::uint32_t right = none;   ///< as `left`
};

/// A search structure over trapezoids: a directed graph without cycles that starts at node 0, in 16 bytes a node.
struct SearchNode {
  struct EdgePart {
    std::uint32_t branch;
    std::uint32_t above;  ///< the node above the edge
  };
  enum Kind : std::uint32_t { leaf, at_point, at_edge };

  constexpr SearchNode() : x(0) {}
  constexpr Kind kind() const { return static_cast<Kind>(packed >> 30); }
  /// A trapezoid, the rank of a point, or the index of an edge.
  constexpr std::uint32_t key() const { return packed & 0x3FFFFFFFU; }
  constexpr void set(Kind kind, std::uint32_t key) { packed = (static_cast<std::uint32_t>(kind) << 30) | key; }

  std::uint32_t packed = 0;
  /// At a point: the node to the left, the one to the right follows it. At an edge: the node below it.
  std::uint32_t child = 0;
  union {
    double x;       ///< at a point: its rounded key
    EdgePart edge;  ///< at an edge
  };
};
static_assert(sizeof(SearchNode) == 16);

struct TrapezoidMap {
  std::vector<Trapezoid> trapezoids;
  std::vector<SearchNode> nodes;
  std::size_t depth = 0;  ///< nodes on the longest path
};

/// Builds the trapezoidal map of edges that do not cross by insertion in random order, with the history of insertions
/// as search structure.
///
/// Walls lean a little, so that points of one x follow each other and no two share a wall; vertical edges are then
/// ordinary. Expected O(n log n) time and linear size for any edges. Source: Mulmuley 1990, Seidel 1991; de Berg et
/// al., chapter 6.
template <CurveFamily F>
class TrapezoidMapBuilder {
 public:
  using Point = typename F::Point;
  using Edges = RankedEdges<Point>;

  TrapezoidMapBuilder(const F& family, const Edges& edges) : family_(family), edges_(edges) {}

  /// @throws Cancelled
  TrapezoidMap build(std::uint64_t seed, const Context& context);

 private:
  static constexpr std::uint32_t none = Trapezoid::none;
  struct Cell : Trapezoid {
    std::uint32_t upper_left = none;   // across the left wall, with the same top
    std::uint32_t lower_left = none;   // across the left wall, with the same bottom
    std::uint32_t upper_right = none;  // across the right wall, with the same top
    std::uint32_t lower_right = none;  // across the right wall, with the same bottom
    std::uint32_t node = none;
  };

  void start();
  void insert_edge(std::uint32_t edge);
  void insert_point(std::uint32_t rank);
  std::uint32_t find(std::uint32_t rank, BranchId branch) const;
  void walk(std::uint32_t edge);
  void begin_chains(std::uint32_t edge);
  void pass_wall(std::uint32_t edge, std::size_t step);
  void end_chains(std::uint32_t edge);
  void write_nodes(std::uint32_t edge, std::size_t step);
  TrapezoidMap finish();

  std::uint32_t new_cell(const Trapezoid& shape);
  std::uint32_t new_leaf(std::uint32_t cell);
  void set_leaf(std::uint32_t node, std::uint32_t cell);
  /// Places for two children, leaves.
  std::uint32_t new_pair(std::uint32_t left_cell, std::uint32_t right_cell);
  void set_point_node(std::uint32_t node, std::uint32_t rank, std::uint32_t child);
  void link_upper(std::uint32_t left, std::uint32_t right);
  void link_lower(std::uint32_t left, std::uint32_t right);

  const F& family_;
  const Edges& edges_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> free_cells_;
  std::vector<SearchNode> nodes_;

  // The current insertion.
  std::vector<std::uint32_t> path_;   // cells that the edge passes through
  std::vector<bool> is_wall_above_;   // whether the point of the wall before each cell of the path lies above it
  std::vector<std::uint32_t> upper_;  // for each cell of the path, what it becomes above the edge
  std::vector<std::uint32_t> lower_;  // and below
  std::uint32_t before_ = none;       // what is left of the first cell before the edge
  std::uint32_t after_ = none;        // what is left of the last cell after the edge
};

}  // namespace quoin
