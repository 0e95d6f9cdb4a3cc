// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "quoin/arrangement/location/grid_locator_impl.h"

/// Building of GridLocator: columns, rows and lists of cells.
namespace quoin {

namespace detail {

inline double finite(double x) {
  constexpr double largest = std::numeric_limits<double>::max();
  return std::clamp(x, -largest, largest);
}

}  // namespace detail

template <GridFamily F>
void GridLocator<F>::rebuild(const Context& context) {
  const Arrangement<F>& a = *arrangement_;
  const F& family = a.family();
  outer_ = OuterFaces<F>(a);
  left_.clear();
  right_.clear();
  walls_.clear();
  columns_.clear();
  bounds_.clear();
  entries_.clear();
  faces_.clear();
  begin_.assign(1, 0);
  map_.reset();
  std::vector<double> keys;
  for (std::size_t i = 0; i < a.vertex_count(); ++i) {
    const dcel::VertexId v(i);
    if (!is_point_vertex(a, v)) continue;
    const double key = family.sweep_key(a.point(v));
    if (std::isfinite(key)) keys.push_back(key);
  }
  std::size_t edges = 0;
  for (std::size_t i = 0; i < a.edge_count(); ++i) {
    const dcel::EdgeId e(i);
    if (!a.cells().is_real(e)) continue;
    ++edges;
    if (family.side(a.left_point(e)) == Side::left) left_.push_back(e);
    if (family.side(a.right_point(e)) == Side::right) right_.push_back(e);
  }
  const auto is_below = [&](const Point& p, const Point& q) { return family.compare_xy(p, q) == Sign::negative; };
  std::sort(left_.begin(), left_.end(), [&](auto e, auto f) { return is_below(a.left_point(e), a.left_point(f)); });
  std::sort(right_.begin(), right_.end(), [&](auto e, auto f) { return is_below(a.right_point(e), a.right_point(f)); });
  is_stale_ = false;
  if (keys.empty()) return;
  find_columns(std::move(keys), edges);
  fill(context);
  bool is_needed = columns_.empty();
  for (std::size_t cell = 0; cell + 1 < begin_.size(); ++cell) is_needed |= begin_[cell + 1] - begin_[cell] > heavy;
  if (is_needed) map_.emplace(a, context);
}

/// Walls so that as many vertices lie in each column; about as many columns as rows, but not so many that edges cross
/// more than a few.
template <GridFamily F>
void GridLocator<F>::find_columns(std::vector<double> keys, std::size_t edge_count) {
  const Arrangement<F>& a = *arrangement_;
  std::sort(keys.begin(), keys.end());
  auto count = static_cast<std::size_t>(std::sqrt(static_cast<double>(keys.size() + edge_count))) + 1;
  for (;; count /= 2) {
    walls_.assign(1, detail::finite(keys.front() - 2 * margin_of(keys.front())));
    for (std::size_t i = 1; i < count; ++i) {
      const double wall = keys[i * keys.size() / count];
      if (wall - walls_.back() > 16 * margin_of(wall)) walls_.push_back(wall);
    }
    walls_.push_back(detail::finite(keys.back() + 2 * margin_of(keys.back())));
    if (count < 2) return;
    std::size_t crossed = 0;
    for (std::size_t i = 0; i < a.edge_count(); ++i) {
      const dcel::EdgeId e(i);
      if (!a.cells().is_real(e)) continue;
      crossed += column_of(a.family().sweep_key(a.right_point(e))) - column_of(a.family().sweep_key(a.left_point(e)));
    }
    if (crossed <= 3 * edge_count) return;
  }
}

/// Lists edges by column, then column by column by cell. Gives up if lists grow beyond a few entries an edge.
template <GridFamily F>
void GridLocator<F>::fill(const Context& context) {
  const Arrangement<F>& a = *arrangement_;
  const F& family = a.family();
  std::vector<std::vector<std::uint32_t>> edges(walls_.size() - 1);
  std::vector<std::vector<std::uint32_t>> vertices(walls_.size() - 1);
  std::size_t total = 0;
  const auto reach = [&](double left, double right) {
    return std::pair(column_of(left - 3 * margin_of(left)), column_of(right + 3 * margin_of(right)));
  };
  for (std::uint32_t i = 0; i < a.edge_count(); ++i) {
    const dcel::EdgeId e(std::size_t{i});
    if (!a.cells().is_real(e)) continue;
    const auto columns = reach(family.sweep_key(a.left_point(e)), family.sweep_key(a.right_point(e)));
    for (std::size_t k = columns.first; k <= columns.second; ++k) edges[k].push_back(i);
    ++total;
  }
  for (std::uint32_t i = 0; i < a.vertex_count(); ++i) {
    const dcel::VertexId v(std::size_t{i});
    if (!is_point_vertex(a, v) || !a.cells().is_isolated(v)) continue;
    const double key = family.sweep_key(a.point(v));
    const auto columns = reach(key, key);
    for (std::size_t k = columns.first; k <= columns.second; ++k) vertices[k].push_back(i);
    ++total;
  }
  std::vector<std::pair<Rows, Entry>> listed;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    context.poll();
    choose_rows(edges[k], vertices[k], k);
    listed.clear();
    for (const std::uint32_t i : edges[k]) {
      const dcel::EdgeId e(std::size_t{i});
      listed.push_back(
          {rows_of(e, k), {family.sweep_key(a.left_point(e)), family.sweep_key(a.right_point(e)), a.branch(e), 2 * i}});
    }
    for (const std::uint32_t i : vertices[k]) {
      const Point& p = a.point(dcel::VertexId(std::size_t{i}));
      const double key = family.sweep_key(p);
      listed.push_back({rows_of_point(family.position(p)), {key, key, BranchId(), 2 * i}});
    }
    place(listed, k);
    if (entries_.size() > 24 * total + 1000) {
      columns_.clear();
      begin_.assign(1, 0);
      return;
    }
    find_faces(k);
  }
}

/// Appends the cells of a column with their lists.
template <GridFamily F>
void GridLocator<F>::place(const std::vector<std::pair<Rows, Entry>>& listed, std::size_t column) {
  const std::uint32_t row_count = columns_[column].row_count;
  std::vector<std::uint32_t> next(row_count + 1, 0);
  for (const auto& [rows, entry] : listed) {
    for (std::uint32_t row = rows.low; row <= rows.high; ++row) ++next[row + 1];
  }
  next[0] = begin_.back();
  for (std::uint32_t row = 0; row < row_count; ++row) {
    next[row + 1] += next[row];
    begin_.push_back(next[row + 1]);
  }
  entries_.resize(begin_.back());
  for (const auto& [rows, entry] : listed) {
    for (std::uint32_t row = rows.low; row <= rows.high; ++row) {
      Entry& target = entries_[next[row]++];
      target = entry;
      target.cell_flags += static_cast<std::uint32_t>(row > rows.low);
    }
  }
}

/// About where an edge passes a column; only good for choosing rows.
template <GridFamily F>
double GridLocator<F>::height_in(dcel::EdgeId e, std::size_t column) const {
  const Arrangement<F>& a = *arrangement_;
  const F& family = a.family();
  const bool has_left = family.side(a.left_point(e)) == Side::interior;
  const bool has_right = family.side(a.right_point(e)) == Side::interior;
  if (!has_left && !has_right) return std::numeric_limits<double>::quiet_NaN();
  const Point2 p = family.position(a.left_point(e));
  const Point2 q = family.position(a.right_point(e));
  if (!has_left) return q.y;
  if (!has_right) return p.y;
  const double left = std::max(p.x, walls_[column]);
  const double right = std::min(q.x, walls_[column + 1]);
  const double part = q.x > p.x ? std::clamp(((left + right) / 2 - p.x) / (q.x - p.x), 0.0, 1.0) : 0.5;
  return p.y + part * (q.y - p.y);
}

template <GridFamily F>
void GridLocator<F>::choose_rows(std::span<const std::uint32_t> edges, std::span<const std::uint32_t> vertices,
                                 std::size_t column) {
  std::vector<double> heights;
  for (const std::uint32_t i : edges) {
    const double height = height_in(dcel::EdgeId(std::size_t{i}), column);
    if (std::isfinite(height)) heights.push_back(height);
  }
  for (const std::uint32_t i : vertices) {
    heights.push_back(arrangement_->family().position(arrangement_->point(dcel::VertexId(std::size_t{i}))).y);
  }
  std::sort(heights.begin(), heights.end());
  const auto first_bound = static_cast<std::uint32_t>(bounds_.size());
  const std::size_t rows = heights.size() / 2 + 1;
  for (std::size_t i = 1; i < rows; ++i) {
    const double bound = heights[i * heights.size() / rows];
    if (bounds_.size() == first_bound || bound - bounds_.back() > 16 * margin_of(bound)) bounds_.push_back(bound);
  }
  const auto row_count = static_cast<std::uint32_t>(bounds_.size() - first_bound + 1);
  columns_.push_back({static_cast<std::uint32_t>(begin_.size() - 1), row_count, first_bound});
  heights_ = {bounds_.data() + first_bound, row_count - 1};
}

template <GridFamily F>
typename GridLocator<F>::Rows GridLocator<F>::rows_of_point(const Point2& p) const {
  const double margin = 2 * margin_of(p.y);
  const auto row = [&](double y) {
    return static_cast<std::uint32_t>(std::upper_bound(heights_.begin(), heights_.end(), y) - heights_.begin());
  };
  return {row(p.y - margin), row(p.y + margin)};
}

/// Rows near the place where a branch passes x.
template <GridFamily F>
typename GridLocator<F>::Rows GridLocator<F>::rows_at(double x, BranchId b) const {
  const F& family = arrangement_->family();
  const auto low = std::partition_point(heights_.begin(), heights_.end(), [&](double height) {
    return family.compare_y_at_x(GridTraits<F>::point(Point2{x, detail::finite(height + 2 * margin_of(height))}), b) ==
           Sign::negative;
  });
  const auto high = std::partition_point(low, heights_.end(), [&](double height) {
    return family.compare_y_at_x(GridTraits<F>::point(Point2{x, detail::finite(height - 2 * margin_of(height))}), b) !=
           Sign::positive;
  });
  return {static_cast<std::uint32_t>(low - heights_.begin()), static_cast<std::uint32_t>(high - heights_.begin())};
}

/// The rows that an edge touches in a column: between its ends, or where it passes just outside the column's walls, so
/// that the rounding of a point's x does not matter.
template <GridFamily F>
typename GridLocator<F>::Rows GridLocator<F>::rows_of(dcel::EdgeId e, std::size_t column) const {
  const Arrangement<F>& a = *arrangement_;
  const F& family = a.family();
  const BranchId b = a.branch(e);
  const auto last = static_cast<std::uint32_t>(heights_.size());
  const double left = family.sweep_key(a.left_point(e));
  const double right = family.sweep_key(a.right_point(e));
  const double from_wall = walls_[column] - margin_of(walls_[column]);
  const double to_wall = walls_[column + 1] + margin_of(walls_[column + 1]);
  // An infinite end has an infinite margin; it loses these comparisons.
  const double from = std::min(from_wall, right - 4 * margin_of(right));
  const double to = std::max(to_wall, left + 4 * margin_of(left));
  const auto rows_of_end = [&](const Point& end) -> Rows {
    if (family.side(end) == Side::bottom) return {0, 0};
    if (family.side(end) == Side::top) return {last, last};
    return rows_of_point(family.position(end));
  };
  const Rows at_left =
      left < from - margin_of(from) && !family.is_vertical(b) ? rows_at(from, b) : rows_of_end(a.left_point(e));
  const Rows at_right =
      right > to + margin_of(to) && !family.is_vertical(b) ? rows_at(to, b) : rows_of_end(a.right_point(e));
  Rows rows{std::min(at_left.low, at_right.low), std::max(at_left.high, at_right.high)};
  const std::optional<Point2> turn = GridTraits<F>::turning_point(family, b);
  if (turn && turn->x > std::max(from, left) - 4 * margin_of(from) &&
      turn->x < std::min(to, right) + 4 * margin_of(to)) {
    const Rows at_turn = rows_of_point(*turn);
    rows = {std::min(rows.low, at_turn.low), std::max(rows.high, at_turn.high)};
  }
  return rows;
}

/// The faces of empty cells, from bottom to top, so that each search can start in the cell below.
template <GridFamily F>
void GridLocator<F>::find_faces(std::size_t column) {
  const Column& c = columns_[column];
  faces_.resize(begin_.size() - 1);
  for (std::uint32_t row = 0; row < c.row_count; ++row) {
    const std::uint32_t cell = c.first_cell + row;
    if (begin_[cell + 1] != begin_[cell]) continue;
    const double low = row > 0 ? heights_[row - 1] : row + 1 < c.row_count ? heights_[row] - 1 : 0;
    const double high = row + 1 < c.row_count ? heights_[row] : low + 1;
    const Point p = GridTraits<F>::point(Point2{walls_[column] / 2 + walls_[column + 1] / 2, low / 2 + high / 2});
    faces_[cell] = row == 0 ? outer_.bottom(*arrangement_, p) : locate_in_column(p, c, row - 1).face();
  }
}

}  // namespace quoin
