// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay_predicates2.h"

#include <algorithm>
#include <limits>

#include "quoin/kernel/call_grid.h"
#include "quoin/triangulation/tie_rule2.h"

namespace quoin {

std::optional<int> grid_unit(std::span<const Point2> points) {
  constexpr int useful_bits = 40;
  int unit = std::numeric_limits<int>::max();
  double largest = 0;
  for (const Point2& p : points) {
    unit = std::min({unit, detail::lowest_bit(p.x), detail::lowest_bit(p.y)});
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
    if (largest > 0 && std::ilogb(largest) - unit > useful_bits) return std::nullopt;
  }
  if (largest == 0 || unit < -250 || unit > 200) return std::nullopt;
  return unit;
}

DelaunayPredicates2::DelaunayPredicates2(std::span<const Point2> points)
    : points_(points), infinite_(static_cast<std::uint32_t>(points.size() - 1)) {
  const std::optional<int> unit = grid_unit(points.first(points.size() - 1));
  if (!unit) return;
  turn_exact_below_ = std::ldexp(1.0, 52 + 2 * *unit);
  circle_exact_below_ = std::ldexp(1.0, 24 + 2 * *unit);
}

bool is_in_circle_by_tie(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  using Corner = const Point2*;
  return detail::is_in_circle_when_lifted<Corner>(
      {&a, &b, &c}, &d, [](Corner p, Corner q) { return lexicographically_less(*p, *q); },
      [](Corner p, Corner q, Corner r) { return orientation(*p, *q, *r); });
}

Sign DelaunayPredicates2::circle_side(const std::array<Vertex2, 3>& t, Vertex2 d) const {
  const Point2& pa = points_[t[0].index()];
  const Point2& pb = points_[t[1].index()];
  const Point2& pc = points_[t[2].index()];
  const Point2& pd = points_[d.index()];
  const filter::InCircle det(pa, pb, pc, pd);
  // The sum of the lifts is at most 3 (x^2 + y^2) of the maxima.
  if (3 * (det.x * det.x + det.y * det.y) < circle_exact_below_) return sign_of(det.value);
  return in_circle(pa, pb, pc, pd);
}

[[gnu::noinline]] bool DelaunayPredicates2::decide_slowly(const TriangleLinks2& t, const Point2& d) const {
  for (unsigned slot = 0; slot < 3; ++slot) {
    if (t.corner[slot] != infinite_) continue;
    const std::uint32_t from = t.corner[next_slot(slot)];
    const std::uint32_t to = t.corner[previous_slot(slot)];
    const Sign side = turn(from, to, d);
    if (side != Sign::zero) return side == Sign::positive;
    // On the line of the edge: in the finite neighbour's circle exactly where it is in the edge.
    return lexicographically_less(points_[from], d) == lexicographically_less(d, points_[to]);
  }
  const Point2& a = points_[t.corner[0]];
  const Point2& b = points_[t.corner[1]];
  const Point2& c = points_[t.corner[2]];
  const Sign side = in_circle(a, b, c, d);
  return side == Sign::zero ? is_in_circle_by_tie(a, b, c, d) : side == Sign::positive;
}

}  // namespace quoin
