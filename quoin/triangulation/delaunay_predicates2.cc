// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay_predicates2.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <vector>

#include "quoin/base/parallel.h"
#include "quoin/kernel/call_grid.h"
#include "quoin/triangulation/tie_rule2.h"

namespace quoin {

namespace {

// What grid_unit asks of some points. Of more the unit is finer, the largest coordinate larger.
struct GridSearch {
  static constexpr int useful_bits = 40;
  int unit = std::numeric_limits<int>::max();
  double largest = 0;

  void add(const GridSearch& other) {
    unit = std::min(unit, other.unit);
    largest = std::max(largest, other.largest);
  }
  void add(const Point2& p) {
    unit = std::min({unit, detail::lowest_bit(p.x), detail::lowest_bit(p.y)});
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  }
  bool is_useful() const { return largest == 0 || std::ilogb(largest) - unit <= useful_bits; }
};

}  // namespace

std::optional<int> grid_unit(std::span<const Point2> points, const Context& context) {
  constexpr std::size_t grain = 1 << 14;
  std::vector<GridSearch> found(chunk_count(points.size(), grain));
  std::atomic<bool> is_useful{true};
  for_each_chunk(context, points.size(), grain, [&](const Chunk& chunk) {
    if (!is_useful.load(std::memory_order_relaxed)) return;
    GridSearch search;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      search.add(points[i]);
      if (i % 256 == 0 && !search.is_useful()) break;
    }
    if (!search.is_useful()) is_useful = false;
    found[chunk.index] = search;
  });
  GridSearch all;
  for (const GridSearch& search : found) all.add(search);
  if (!is_useful || !all.is_useful()) return std::nullopt;
  if (all.largest == 0 || all.unit < -250 || all.unit > 200) return std::nullopt;
  return all.unit;
}

DelaunayPredicates2::DelaunayPredicates2(std::span<const Point2> points, const Context& context)
    : points_(points), infinite_(static_cast<std::uint32_t>(points.size() - 1)) {
  const std::optional<int> unit = grid_unit(points.first(points.size() - 1), context);
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

namespace {

// The filter of in_conflict with the sum P of all products of lifts and minors, which is far smaller than the square of
// lifts where one corner is close to d. Relative errors, in units of u = 2^-53: differences 1, lifts 4, minors 4 of the
// sum of their two products, terms 9, their sum 2 more: 11 u P, and u P is left for higher orders and the rounding of
// P. Underflow is at most 2^-1075 in each of 12 products, times lifts or minors below 2^100.
int in_circle_by_products(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double ax = a.x - d.x;
  const double ay = a.y - d.y;
  const double bx = b.x - d.x;
  const double by = b.y - d.y;
  const double cx = c.x - d.x;
  const double cy = c.y - d.y;
  const double la = ax * ax + ay * ay;
  const double lb = bx * bx + by * by;
  const double lc = cx * cx + cy * cy;
  if (!(la + lb + lc < 0x1p100)) return 0;
  const double value = la * (bx * cy - by * cx) + lb * (cx * ay - cy * ax) + lc * (ax * by - ay * bx);
  const double size = la * (std::fabs(bx * cy) + std::fabs(by * cx)) + lb * (std::fabs(cx * ay) + std::fabs(cy * ax)) +
                      lc * (std::fabs(ax * by) + std::fabs(ay * bx));
  if (std::fabs(value) > 12 * 0x1p-53 * size + 0x1p-960) return value > 0 ? 1 : -1;
  return 0;
}

}  // namespace

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
  const int sign = in_circle_by_products(a, b, c, d);
  if (sign != 0) return sign > 0;
  Tier ignored{};
  const Sign side = detail::exact_in_circle(a, b, c, d, ignored);
  return side == Sign::zero ? is_in_circle_by_tie(a, b, c, d) : side == Sign::positive;
}

}  // namespace quoin
