// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "quoin/arrangement/location/trapezoid_locator.h"
#include "quoin/arrangement/location/trapezoid_map_impl.h"

/// Bodies of TrapezoidLocator, for the one source file per family that instantiates it.
namespace quoin {

template <CurveFamily F>
void TrapezoidLocator<F>::rebuild(const Context& context) {
  const Arrangement<F>& a = *arrangement_;
  outer_ = OuterFaces<F>(a);
  edges_ = ranked_edges(a, context);
  if (edges_.points.size() >= (1U << 30) || edges_.edges.size() >= (1U << 30)) {
    throw InputError("more edges than a trapezoidal map holds");
  }
  // Longest paths of about 4 log2(n) were measured; a map with one half as long again is built once more, in another
  // order.
  const double usual = 6 * std::log2(static_cast<double>(edges_.edges.size() + 2)) + 20;
  for (std::uint64_t attempt = 0; attempt < 4; ++attempt) {
    TrapezoidMap map = TrapezoidMapBuilder<F>(a.family(), edges_).build(context.seed() + attempt, context);
    if (attempt == 0 || map.depth < map_.depth) map_ = std::move(map);
    if (static_cast<double>(map_.depth) <= usual) break;
  }
  faces_.clear();
  for (const Trapezoid& trapezoid : map_.trapezoids) faces_.push_back(face_of(trapezoid));
  is_stale_ = false;
}

template <CurveFamily F>
dcel::FaceId TrapezoidLocator<F>::face_of(const Trapezoid& t) const {
  const Arrangement<F>& a = *arrangement_;
  if (t.bottom != Trapezoid::none) return face_above(a, edge_id(t.bottom));
  if (t.top != Trapezoid::none) return face_below(a, edge_id(t.top));
  if (t.left == Trapezoid::none) return outer_.leftmost_bottom(a);
  return t.right == Trapezoid::none ? outer_.rightmost_bottom(a) : outer_.bottom(a, edges_.points[t.right]);
}

template <CurveFamily F>
typename TrapezoidLocator<F>::Query TrapezoidLocator<F>::prepare(const Point& p) const {
  const F& family = arrangement_->family();
  const double key = family.sweep_key(p);
  return {p, key, std::max(2 * family.key_error(), 0x1p-44 * std::fabs(key))};
}

template <CurveFamily F>
Sign TrapezoidLocator<F>::compare(const Query& query, const SearchNode& node) const {
  const double difference = query.key - node.x;
  if (std::fabs(difference) > std::max(query.margin, 0x1p-44 * std::fabs(node.x))) {
    return difference < 0 ? Sign::negative : Sign::positive;
  }
  return arrangement_->family().compare_xy(query.point, edges_.points[node.key()]);
}

template <CurveFamily F>
Location TrapezoidLocator<F>::locate(const Point& p) const {
  const Arrangement<F>& a = *arrangement_;
  if (is_stale_) return NaiveLocator<F>(a).locate(p);
  if (is_pole(a.family(), p)) return outer_.pole(a, a.family().side(p));
  const Point copy = left_copy_of(a.family(), p);
  const Query query = prepare(copy);
  std::uint32_t at = 0;
  for (;;) {
    const SearchNode& node = map_.nodes[at];
    if (node.kind() == SearchNode::leaf) return faces_[node.key()];
    if (node.kind() == SearchNode::at_point) {
      const Sign order = compare(query, node);
      if (order == Sign::zero) return edges_.vertices[node.key()];
      at = node.child + static_cast<std::uint32_t>(order == Sign::positive);
    } else {
      const Sign side = a.family().compare_y_at_x(copy, BranchId(std::size_t{node.edge.branch}));
      if (side == Sign::zero) return place_on_edge(a, edge_id(node.key()), copy);
      at = side == Sign::positive ? node.edge.above : node.child;
    }
  }
}

/// The trapezoid just right of and above the point, or just left of and below it.
template <CurveFamily F>
std::uint32_t TrapezoidLocator<F>::descend(const Query& query, Direction direction) const {
  const Sign at_zero = direction == Direction::up ? Sign::positive : Sign::negative;
  std::uint32_t at = 0;
  for (;;) {
    const SearchNode& node = map_.nodes[at];
    if (node.kind() == SearchNode::leaf) return node.key();
    Sign side = node.kind() == SearchNode::at_point
                    ? compare(query, node)
                    : arrangement_->family().compare_y_at_x(query.point, BranchId(std::size_t{node.edge.branch}));
    if (side == Sign::zero) side = at_zero;
    if (node.kind() == SearchNode::at_point) {
      at = node.child + static_cast<std::uint32_t>(side == Sign::positive);
    } else {
      at = side == Sign::positive ? node.edge.above : node.child;
    }
  }
}

template <CurveFamily F>
typename TrapezoidLocator<F>::Ahead TrapezoidLocator<F>::look(const Point& p, Direction direction) const {
  const Trapezoid& trapezoid = map_.trapezoids[descend(prepare(p), direction)];
  const bool up = direction == Direction::up;
  const std::uint32_t wall = up ? trapezoid.right : trapezoid.left;
  return {edge_id(up ? trapezoid.top : trapezoid.bottom),
          wall == Trapezoid::none ? dcel::VertexId() : edges_.vertices[wall]};
}

template <CurveFamily F>
std::size_t TrapezoidLocator<F>::steps(const Point& p) const {
  const Query query = prepare(p);
  std::size_t count = 1;
  for (std::uint32_t at = 0; map_.nodes[at].kind() != SearchNode::leaf; ++count) {
    const SearchNode& node = map_.nodes[at];
    if (node.kind() == SearchNode::at_point) {
      at = node.child + static_cast<std::uint32_t>(compare(query, node) == Sign::positive);
    } else {
      const Sign side = arrangement_->family().compare_y_at_x(p, BranchId(std::size_t{node.edge.branch}));
      at = side == Sign::positive ? node.edge.above : node.child;
    }
  }
  return count;
}

}  // namespace quoin
