// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "quoin/arrangement/location/grid_locator.h"
#include "quoin/arrangement/location/trapezoid_locator_impl.h"

/// Queries of GridLocator; for the one source file per family that instantiates it. Building is in grid_build_impl.h.
namespace quoin {

/// How far apart rounded coordinates must be to be in order.
template <GridFamily F>
double GridLocator<F>::margin_of(double x) const {
  const F& family = arrangement_->family();
  return std::max(2 * std::max(family.error(), family.key_error()), 0x1p-44 * std::fabs(x));
}

template <GridFamily F>
std::size_t GridLocator<F>::column_of(double x) const {
  const auto after = std::upper_bound(walls_.begin() + 1, walls_.end() - 1, x);
  return static_cast<std::size_t>(after - walls_.begin() - 1);
}

template <GridFamily F>
Location GridLocator<F>::locate(const Point& p) const {
  if (is_stale_) return NaiveLocator<F>(*arrangement_).locate(p);
  const Point2 position = arrangement_->family().position(p);
  if (walls_.empty() || position.x < walls_.front()) return locate_in_slab(p, left_);
  if (position.x > walls_.back()) return locate_in_slab(p, right_);
  if (columns_.empty()) return map_->locate(p);
  const Column& column = columns_[column_of(position.x)];
  const double* bounds = bounds_.data() + column.first_bound;
  const auto row =
      static_cast<std::uint32_t>(std::upper_bound(bounds, bounds + (column.row_count - 1), position.y) - bounds);
  return locate_in_column(p, column, row);
}

/// Where edges are in order from bottom to top and none ends.
template <GridFamily F>
Location GridLocator<F>::locate_in_slab(const Point& p, const std::vector<dcel::EdgeId>& edges) const {
  const Arrangement<F>& a = *arrangement_;
  const auto above = std::partition_point(edges.begin(), edges.end(), [&](dcel::EdgeId e) {
    return a.family().compare_y_at_x(p, a.branch(e)) == Sign::positive;
  });
  if (above != edges.end() && a.family().compare_y_at_x(p, a.branch(*above)) == Sign::zero) return *above;
  return above == edges.begin() ? outer_.bottom(a, p) : face_above(a, *(above - 1));
}

template <GridFamily F>
Location GridLocator<F>::locate_in_column(const Point& p, const Column& column, std::uint32_t row) const {
  const double key = arrangement_->family().sweep_key(p);
  std::uint32_t visited = 0;
  Search search{p, key, margin_of(key), dcel::EdgeId(), false};
  for (std::uint32_t cell = column.first_cell + row;; --cell) {
    const std::uint32_t count = begin_[cell + 1] - begin_[cell];
    if (map_ && (count > heavy || ++visited > long_walk)) return map_->locate(p);
    if (count == 0 && search.best.is_none()) return faces_[cell];
    search.continues = false;
    if (const std::optional<Location> found = search_cell(search, cell)) return *found;
    if (!search.best.is_none() && !search.continues) return face_above(*arrangement_, search.best);
    if (cell == column.first_cell) return outer_.bottom(*arrangement_, p);
  }
}

template <GridFamily F>
Sign GridLocator<F>::compare_end(const Search& search, double key, const Point& end) const {
  const double difference = search.key - key;
  if (std::fabs(difference) > std::max(search.margin, 0x1p-44 * std::fabs(key))) {
    return difference < 0 ? Sign::negative : Sign::positive;
  }
  return arrangement_->family().compare_xy(search.point, end);
}

/// Looks through a cell for something at the point, and else for the highest edge below it.
template <GridFamily F>
std::optional<Location> GridLocator<F>::search_cell(Search& search, std::uint32_t cell) const {
  const Arrangement<F>& a = *arrangement_;
  for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i) {
    const Entry& entry = entries_[i];
    if (entry.branch.is_none()) {
      const dcel::VertexId v(entry.cell());
      if (compare_end(search, entry.left, a.point(v)) == Sign::zero) return v;
      continue;
    }
    const dcel::EdgeId e(entry.cell());
    const Sign from_left = compare_end(search, entry.left, a.left_point(e));
    if (from_left == Sign::negative) continue;
    const Sign from_right = compare_end(search, entry.right, a.right_point(e));
    if (from_right == Sign::positive) continue;
    if (from_left == Sign::zero) return a.left(e);
    if (from_right == Sign::zero) return a.right(e);
    const Sign side = a.family().compare_y_at_x(search.point, entry.branch);
    if (side == Sign::zero) return e;
    if (side == Sign::negative) continue;
    if (e == search.best || search.best.is_none() || order_of_edges(a, e, search.best) == Sign::positive) {
      search.best = e;
      search.continues = entry.continues();
    }
  }
  return std::nullopt;
}

}  // namespace quoin
