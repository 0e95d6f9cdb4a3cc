// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/planar_hull.h"

#include <algorithm>
#include <numeric>

#include "quoin/base/parallel_sort.h"
#include "quoin/kernel/predicates2.h"

namespace quoin {

namespace {

/// Appends the chain below all points of a list in lexicographic order, without its last point.
template <class Iterator>
void append_lower_chain(std::span<const Point2> points, Iterator first, Iterator last,
                        std::vector<std::uint32_t>& hull) {
  const std::size_t start = hull.size();
  for (; first != last; ++first) {
    while (hull.size() >= start + 2 &&
           orientation(points[hull[hull.size() - 2]], points[hull.back()], points[*first]) != Sign::positive) {
      hull.pop_back();
    }
    hull.push_back(*first);
  }
  hull.pop_back();
}

}  // namespace

std::vector<std::uint32_t> planar_hull(std::span<const Point2> points, const Context& context) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  sort_parallel(context, order, [&](std::uint32_t a, std::uint32_t b) {
    if (points[a] != points[b]) return lexicographically_less(points[a], points[b]);
    return a < b;
  });
  const auto is_equal = [&](std::uint32_t a, std::uint32_t b) { return points[a] == points[b]; };
  order.erase(std::unique(order.begin(), order.end(), is_equal), order.end());
  if (order.size() < 2) return order;
  std::vector<std::uint32_t> hull;
  append_lower_chain(points, order.begin(), order.end(), hull);
  append_lower_chain(points, order.rbegin(), order.rend(), hull);
  return hull;
}

}  // namespace quoin
