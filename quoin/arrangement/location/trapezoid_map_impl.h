// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <random>
#include <utility>

#include "quoin/arrangement/location/trapezoid_map.h"
#include "quoin/base/error.h"

/// Bodies of TrapezoidMapBuilder.
namespace quoin {

template <CurveFamily F>
TrapezoidMap TrapezoidMapBuilder<F>::build(std::uint64_t seed, const Context& context) {
  const std::size_t edge_count = edges_.edges.size();
  std::vector<std::uint32_t> items(edge_count + edges_.lone.size());
  std::mt19937_64 random(seed);
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    const auto j = static_cast<std::size_t>(random() % (i + 1));
    items[i] = items[j];
    items[j] = i;
  }
  start();
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i % 256 == 0) context.poll();
    if (items[i] < edge_count) {
      insert_edge(items[i]);
    } else {
      insert_point(edges_.lone[items[i] - edge_count]);
    }
  }
  return finish();
}

template <CurveFamily F>
void TrapezoidMapBuilder<F>::start() {
  cells_.clear();
  free_cells_.clear();
  nodes_.clear();
  cells_.reserve(3 * edges_.edges.size() + 1);
  nodes_.reserve(6 * edges_.edges.size() + 1);
  new_leaf(new_cell(Trapezoid{}));
}

template <CurveFamily F>
std::uint32_t TrapezoidMapBuilder<F>::new_cell(const Trapezoid& shape) {
  std::uint32_t cell;
  if (free_cells_.empty()) {
    cell = static_cast<std::uint32_t>(cells_.size());
    cells_.emplace_back();
  } else {
    cell = free_cells_.back();
    free_cells_.pop_back();
    cells_[cell] = Cell{};
  }
  static_cast<Trapezoid&>(cells_[cell]) = shape;
  return cell;
}

template <CurveFamily F>
void TrapezoidMapBuilder<F>::set_leaf(std::uint32_t node, std::uint32_t cell) {
  nodes_[node].set(SearchNode::leaf, cell);
  cells_[cell].node = node;
}

template <CurveFamily F>
std::uint32_t TrapezoidMapBuilder<F>::new_leaf(std::uint32_t cell) {
  nodes_.emplace_back();
  const auto node = static_cast<std::uint32_t>(nodes_.size() - 1);
  set_leaf(node, cell);
  return node;
}

template <CurveFamily F>
std::uint32_t TrapezoidMapBuilder<F>::new_pair(std::uint32_t left_cell, std::uint32_t right_cell) {
  nodes_.resize(nodes_.size() + 2);
  const auto pair = static_cast<std::uint32_t>(nodes_.size() - 2);
  if (left_cell != none) set_leaf(pair, left_cell);
  if (right_cell != none) set_leaf(pair + 1, right_cell);
  return pair;
}

template <CurveFamily F>
void TrapezoidMapBuilder<F>::set_point_node(std::uint32_t node, std::uint32_t rank, std::uint32_t child) {
  SearchNode& n = nodes_[node];
  n.set(SearchNode::at_point, rank);
  n.child = child;
  n.x = family_.sweep_key(edges_.points[rank]);
}

template <CurveFamily F>
void TrapezoidMapBuilder<F>::link_upper(std::uint32_t left, std::uint32_t right) {
  if (left != none) cells_[left].upper_right = right;
  if (right != none) cells_[right].upper_left = left;
}

template <CurveFamily F>
void TrapezoidMapBuilder<F>::link_lower(std::uint32_t left, std::uint32_t right) {
  if (left != none) cells_[left].lower_right = right;
  if (right != none) cells_[right].lower_left = left;
}

/// The cell just right of a point, where a curve leaves it; without a curve, that holds the point.
template <CurveFamily F>
std::uint32_t TrapezoidMapBuilder<F>::find(std::uint32_t rank, BranchId branch) const {
  std::uint32_t at = 0;
  for (;;) {
    const SearchNode& node = nodes_[at];
    if (node.kind() == SearchNode::leaf) return node.key();
    if (node.kind() == SearchNode::at_point) {
      at = node.child + static_cast<std::uint32_t>(rank >= node.key());
      continue;
    }
    const Sign side = edges_.edges[node.key()].left == rank
                          ? family_.compare_right(branch, BranchId(std::size_t{node.edge.branch}), edges_.points[rank])
                          : family_.compare_y_at_x(edges_.points[rank], BranchId(std::size_t{node.edge.branch}));
    if (side == Sign::zero) throw InternalError("trapezoids: edges overlap");
    at = side == Sign::positive ? node.edge.above : node.child;
  }
}

template <CurveFamily F>
void TrapezoidMapBuilder<F>::insert_point(std::uint32_t rank) {
  const std::uint32_t old = find(rank, BranchId());
  const std::uint32_t left = new_cell({cells_[old].top, cells_[old].bottom, cells_[old].left, rank});
  const std::uint32_t right = new_cell({cells_[old].top, cells_[old].bottom, rank, cells_[old].right});
  link_upper(cells_[old].upper_left, left);
  link_lower(cells_[old].lower_left, left);
  link_upper(left, right);
  link_lower(left, right);
  link_upper(right, cells_[old].upper_right);
  link_lower(right, cells_[old].lower_right);
  const std::uint32_t node = cells_[old].node;
  set_point_node(node, rank, new_pair(left, right));
  free_cells_.push_back(old);
}

template <CurveFamily F>
void TrapezoidMapBuilder<F>::insert_edge(std::uint32_t edge) {
  walk(edge);
  begin_chains(edge);
  for (std::size_t step = 1; step < path_.size(); ++step) pass_wall(edge, step);
  end_chains(edge);
  for (std::size_t step = 0; step < path_.size(); ++step) write_nodes(edge, step);
  free_cells_.insert(free_cells_.end(), path_.begin(), path_.end());
}

/// The cells from the left end of the edge to its right end.
template <CurveFamily F>
void TrapezoidMapBuilder<F>::walk(std::uint32_t edge) {
  const auto& e = edges_.edges[edge];
  path_.assign(1, find(e.left, e.branch));
  is_wall_above_.assign(1, false);
  for (;;) {
    const Cell& cell = cells_[path_.back()];
    if (cell.right >= e.right) return;
    const bool is_above = family_.compare_y_at_x(edges_.points[cell.right], e.branch) == Sign::positive;
    path_.push_back(is_above ? cell.lower_right : cell.upper_right);
    is_wall_above_.push_back(is_above);
    if (path_.back() == none) throw InternalError("trapezoids: edges cross");
  }
}

/// The two cells that start at the left end of the edge, and what is left before it.
template <CurveFamily F>
void TrapezoidMapBuilder<F>::begin_chains(std::uint32_t edge) {
  const std::uint32_t point = edges_.edges[edge].left;
  const Cell old = cells_[path_[0]];
  upper_.assign(1, new_cell({old.top, edge, point, none}));
  new_leaf(upper_[0]);
  lower_.assign(1, new_cell({edge, old.bottom, point, none}));
  new_leaf(lower_[0]);
  before_ = none;
  if (old.left == point) {
    link_upper(old.upper_left, upper_[0]);
    link_lower(old.lower_left, lower_[0]);
    return;
  }
  before_ = new_cell({old.top, old.bottom, old.left, point});
  link_upper(old.upper_left, before_);
  link_lower(old.lower_left, before_);
  link_upper(before_, upper_[0]);
  link_lower(before_, lower_[0]);
}

/// The part of the wall on the side of its point stays and ends a cell there; the cell on the other side goes on.
template <CurveFamily F>
void TrapezoidMapBuilder<F>::pass_wall(std::uint32_t edge, std::size_t step) {
  const std::uint32_t from = path_[step - 1];
  const std::uint32_t to = path_[step];
  const Cell left = cells_[from];
  const Cell right = cells_[to];
  std::uint32_t upper = upper_.back();
  std::uint32_t lower = lower_.back();
  if (is_wall_above_[step]) {
    cells_[upper].right = right.left;
    const std::uint32_t next = new_cell({right.top, edge, right.left, none});
    new_leaf(next);
    if (left.upper_right == to) {
      link_upper(upper, next);
    } else {
      link_upper(upper, left.upper_right);
      link_upper(right.upper_left, next);
    }
    link_lower(upper, next);
    upper = next;
  } else {
    cells_[lower].right = right.left;
    const std::uint32_t next = new_cell({edge, right.bottom, right.left, none});
    new_leaf(next);
    if (left.lower_right == to) {
      link_lower(lower, next);
    } else {
      link_lower(lower, left.lower_right);
      link_lower(right.lower_left, next);
    }
    link_upper(lower, next);
    lower = next;
  }
  upper_.push_back(upper);
  lower_.push_back(lower);
}

template <CurveFamily F>
void TrapezoidMapBuilder<F>::end_chains(std::uint32_t edge) {
  const std::uint32_t point = edges_.edges[edge].right;
  const Cell old = cells_[path_.back()];
  cells_[upper_.back()].right = point;
  cells_[lower_.back()].right = point;
  after_ = none;
  if (old.right == point) {
    link_upper(upper_.back(), old.upper_right);
    link_lower(lower_.back(), old.lower_right);
    return;
  }
  after_ = new_cell({old.top, old.bottom, point, old.right});
  link_upper(after_, old.upper_right);
  link_lower(after_, old.lower_right);
  link_upper(upper_.back(), after_);
  link_lower(lower_.back(), after_);
}

/// What the leaf of a cell of the path becomes.
template <CurveFamily F>
void TrapezoidMapBuilder<F>::write_nodes(std::uint32_t edge, std::size_t step) {
  const auto& e = edges_.edges[edge];
  std::uint32_t node = cells_[path_[step]].node;
  if (step == 0 && before_ != none) {
    const std::uint32_t pair = new_pair(before_, none);
    set_point_node(node, e.left, pair);
    node = pair + 1;
  }
  if (step + 1 == path_.size() && after_ != none) {
    const std::uint32_t pair = new_pair(none, after_);
    set_point_node(node, e.right, pair);
    node = pair;
  }
  SearchNode& n = nodes_[node];
  n.set(SearchNode::at_edge, edge);
  n.child = cells_[lower_[step]].node;
  n.edge = {e.branch.value, cells_[upper_[step]].node};
}

/// Renumbers nodes so that parents come before children, those near the root first, and pairs stay together; cells
/// without gaps, in the order in which leaves are met.
template <CurveFamily F>
TrapezoidMap TrapezoidMapBuilder<F>::finish() {
  TrapezoidMap result;
  std::vector<std::uint32_t> parents(nodes_.size(), 0);
  for (const SearchNode& node : nodes_) {
    if (node.kind() == SearchNode::leaf) continue;
    ++parents[node.child];
    ++parents[node.kind() == SearchNode::at_point ? node.child + 1 : node.edge.above];
  }
  std::vector<std::uint32_t> order(1, 0);
  std::vector<std::uint32_t> number(nodes_.size(), 0);
  std::vector<std::uint32_t> depth(nodes_.size(), 1);
  order.reserve(nodes_.size());
  const auto visit = [&](std::uint32_t child, std::uint32_t from) {
    depth[child] = std::max(depth[child], depth[from] + 1);
    if (--parents[child] > 0) return;
    number[child] = static_cast<std::uint32_t>(order.size());
    order.push_back(child);
  };
  std::size_t done = 0;
  while (done < order.size()) {
    const std::uint32_t at = order[done++];
    const SearchNode& node = nodes_[at];
    result.depth = std::max<std::size_t>(result.depth, depth[at]);
    if (node.kind() == SearchNode::leaf) continue;
    visit(node.child, at);
    visit(node.kind() == SearchNode::at_point ? node.child + 1 : node.edge.above, at);
  }
  result.nodes.reserve(order.size());
  for (const std::uint32_t old : order) {
    SearchNode node = nodes_[old];
    if (node.kind() == SearchNode::leaf) {
      result.trapezoids.push_back(cells_[node.key()]);
      node.set(SearchNode::leaf, static_cast<std::uint32_t>(result.trapezoids.size() - 1));
    } else {
      node.child = number[node.child];
      if (node.kind() == SearchNode::at_edge) node.edge.above = number[node.edge.above];
    }
    result.nodes.push_back(node);
  }
  nodes_ = {};
  cells_ = {};
  return result;
}

}  // namespace quoin
