// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "quoin/arrangement/pieces.h"
#include "quoin/base/parallel_sort.h"

namespace quoin {

/// The pieces that start or end at each point of a list, as offsets into one array.
class PointIncidences {
 public:
  PointIncidences(std::size_t point_count, std::span<const Piece> pieces);

  /// Twice a piece, plus one where the piece ends.
  std::span<const std::uint32_t> at(std::uint32_t point) const {
    return {entries_.data() + begin_[point], begin_[point + 1] - begin_[point]};
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> entries_;
};

struct KeyedPoint {
  double key;
  std::uint32_t point;
  bool operator<(const KeyedPoint& other) const { return key != other.key ? key < other.key : point < other.point; }
};

/// By key, then point; the points come in order of their numbers. O(n).
void sort_by_key(const Context& context, std::vector<KeyedPoint>& list);

/// Indices of the points in lexicographic order; equal ones by index.
///
/// Sorted by rounded keys first; where neighbours' keys are closer than their errors, by exact comparisons. O(n log n),
/// linear if the points come in order.
template <CurveFamily F>
std::vector<std::uint32_t> sorted_points(const Context& context, const F& family,
                                         std::span<const typename F::Point> points) {
  std::vector<KeyedPoint> keyed(points.size());
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    keyed[i] = {family.sweep_key(points[i]), static_cast<std::uint32_t>(i)};
    if (std::isfinite(keyed[i].key)) largest = std::max(largest, std::fabs(keyed[i].key));
  }
  sort_by_key(context, keyed);
  const auto is_before = [&](const KeyedPoint& a, const KeyedPoint& b) {
    const Sign order = family.compare_xy(points[a.point], points[b.point]);
    return order != Sign::zero ? order == Sign::negative : a.point < b.point;
  };
  const double gap = std::max(2 * family.key_error(), 0x1p-44 * largest);
  for (std::size_t begin = 0; begin < keyed.size();) {
    std::size_t end = begin + 1;
    while (end < keyed.size() && !(keyed[end].key - keyed[end - 1].key > gap)) ++end;
    if (end - begin > 1) {
      const auto first = keyed.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto last = keyed.begin() + static_cast<std::ptrdiff_t>(end);
      if (!std::is_sorted(first, last, is_before)) std::sort(first, last, is_before);
    }
    begin = end;
  }
  std::vector<std::uint32_t> order(keyed.size());
  for (std::size_t i = 0; i < keyed.size(); ++i) order[i] = keyed[i].point;
  return order;
}

/// Different points in lexicographic order, and which of them each of a list has become.
template <class Point>
struct DistinctPoints {
  std::vector<Point> points;
  std::vector<std::uint32_t> place;
};

/// Of equal points the first one is kept.
template <CurveFamily F>
DistinctPoints<typename F::Point> distinct_points(const Context& context, const F& family,
                                                  std::span<const typename F::Point> points) {
  const std::vector<std::uint32_t> order = sorted_points(context, family, points);
  DistinctPoints<typename F::Point> result;
  result.place.resize(order.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || family.compare_xy(points[order[i - 1]], points[order[i]]) != Sign::zero) ++count;
    result.place[order[i]] = static_cast<std::uint32_t>(count - 1);
  }
  result.points.reserve(count);
  for (const std::uint32_t i : order) {
    if (result.place[i] == result.points.size()) result.points.push_back(points[i]);
  }
  return result;
}

/// Pieces by their left ends, by counting: those of one end as they were.
template <CurveFamily F>
PieceList<F> renumbered(const PieceList<F>& list, DistinctPoints<typename F::Point> distinct) {
  const std::vector<std::uint32_t>& place = distinct.place;
  PieceList<F> result;
  result.curve_count = list.curve_count;
  result.points = std::move(distinct.points);
  std::vector<std::uint32_t> begin(result.points.size() + 1, 0);
  for (const Piece& piece : list.pieces) ++begin[place[piece.left] + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  result.pieces.resize(list.pieces.size());
  for (const Piece& piece : list.pieces) {
    Piece& to = result.pieces[begin[place[piece.left]]++];
    to = piece;
    to.left = place[piece.left];
    to.right = place[piece.right];
  }
  result.lone_points.reserve(list.lone_points.size());
  for (const LonePoint& lone : list.lone_points) result.lone_points.push_back({place[lone.point], lone.curve});
  return result;
}

/// The same list with equal points once, all in lexicographic order, and pieces by their left ends: the sweep then
/// passes over memory in order.
template <CurveFamily F>
PieceList<F> sorted_list(const Context& context, const F& family, const PieceList<F>& list) {
  return renumbered(list, distinct_points(context, family, std::span<const typename F::Point>(list.points)));
}
/// The list is empty afterwards, its points before pieces are moved.
template <CurveFamily F>
PieceList<F> sorted_list(const Context& context, const F& family, PieceList<F>&& list) {
  auto distinct = distinct_points(context, family, std::span<const typename F::Point>(list.points));
  list.points = std::vector<typename F::Point>();
  PieceList<F> result = renumbered(list, std::move(distinct));
  list = PieceList<F>();
  return result;
}

}  // namespace quoin
