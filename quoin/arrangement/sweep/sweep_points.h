// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
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

/// The same list with points in lexicographic order and pieces by their left ends: the sweep then passes over memory in
/// order.
template <CurveFamily F>
PieceList<F> sorted_list(const Context& context, const F& family, const PieceList<F>& list) {
  const std::vector<std::uint32_t> order =
      sorted_points(context, family, std::span<const typename F::Point>(list.points));
  PieceList<F> result;
  result.curve_count = list.curve_count;
  std::vector<std::uint32_t> place(order.size());
  result.points.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = static_cast<std::uint32_t>(i);
    result.points[i] = list.points[order[i]];
  }
  // By counting, stable.
  std::vector<std::uint32_t> begin(order.size() + 1, 0);
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

}  // namespace quoin
