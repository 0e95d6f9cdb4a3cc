// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/planar_hull.h"

#include <algorithm>
#include <numeric>

#include "quoin/base/parallel_sort.h"
#include "quoin/kernel/predicates2.h"

namespace quoin {

std::vector<std::uint32_t> planar_hull(std::span<const Point2> points, const Context& context) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  sort_parallel(context, order, [&](std::uint32_t a, std::uint32_t b) {
    if (points[a] != points[b]) return lexicographically_less(points[a], points[b]);
    return a < b;
  });
  const auto is_equal = [&](std::uint32_t a, std::uint32_t b) { return points[a] == points[b]; };
  order.erase(std::unique(order.begin(), order.end(), is_equal), order.end());
  const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return orientation(points[a], points[b], points[c]);
  };
  return planar_hull_of_sorted(order, turn, context);
}

}  // namespace quoin
