// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// Corners counterclockwise, from the first, of points in lexicographic order, no two of them equal. `turn` gives the
/// sign of three. O(n). @throws Cancelled
template <class Turn>
std::vector<std::uint32_t> planar_hull_of_sorted(std::span<const std::uint32_t> order, const Turn& turn,
                                                 const Context& context) {
  if (order.size() < 2) return {order.begin(), order.end()};
  std::vector<std::uint32_t> hull;
  std::size_t polled = 0;
  // The chain below all points, without its last.
  const auto append_chain = [&](auto first, auto last) {
    const std::size_t start = hull.size();
    for (; first != last; ++first) {
      if (polled++ % 256 == 0) context.poll();
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), *first) != Sign::positive) {
        hull.pop_back();
      }
      hull.push_back(*first);
    }
    hull.pop_back();
  };
  append_chain(order.begin(), order.end());
  append_chain(order.rbegin(), order.rend());
  return hull;
}

/// Vertices of the convex hull of finite points of the plane, counterclockwise from the lexicographically smallest one;
/// of equal points the first. One if all points are equal, the two ends if they are on a line. O(n log n).
std::vector<std::uint32_t> planar_hull(std::span<const Point2> points, const Context& context);

}  // namespace quoin
