// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay_location.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_set>

#include "quoin/base/error.h"
#include "quoin/kernel/call_grid.h"
#include "quoin/kernel/predicates3.h"

namespace quoin {

namespace {

void require_finite(const Point3& p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    throw InputError("a point to be found in a triangulation is not finite");
  }
}

/// Sign of |p - a|^2 - |p - b|^2.
///
/// Computed squares err by at most 3 u each, their sums by 2 u more: 5 u (1 + 8 u) of either, less than 6e-16, and the
/// difference by u; 2^-1000 is for underflow. Where anything overflows nothing is decided. Exact squares of differences
/// below 2^(B + 1), of integers of B bits, sum up to less than 2^(2B + 4), as Quadratic holds.
int compare_distances(const Point3& p, const Point3& a, const Point3& b) {
  const auto square = [&p](const Point3& q) {
    const double x = p.x - q.x;
    const double y = p.y - q.y;
    const double z = p.z - q.z;
    return x * x + y * y + z * z;
  };
  const double to_a = square(a);
  const double to_b = square(b);
  if (std::fabs(to_a - to_b) > 8e-16 * (to_a + to_b) + 0x1p-1000 && to_a + to_b <= 0x1p1000)
    return to_a > to_b ? 1 : -1;
  Tier ignored;
  const std::array<double, 9> values{p.x, p.y, p.z, a.x, a.y, a.z, b.x, b.y, b.z};
  return to_int(detail::decide_on_grid(values, ignored, [&]<class N>(const detail::CallReader<N>& difference) {
    using Quadratic = typename N::Quadratic;
    const auto square_distance = [&](const Point3& q) {
      const auto x = difference(p.x, q.x);
      const auto y = difference(p.y, q.y);
      const auto z = difference(p.z, q.z);
      return detail::product<Quadratic>(x, x) + detail::product<Quadratic>(y, y) + detail::product<Quadratic>(z, z);
    };
    return (square_distance(a) - square_distance(b)).sign();
  }));
}

}  // namespace

DelaunayLocation DelaunayLocator::locate(const Point3& p, std::uint32_t start) const {
  require_finite(p);
  const Delaunay3& t = triangulation_;
  if (t.dimension() < 3) throw InputError("points are located in triangulations of dimension 3 only");
  const auto cells = t.cells();
  std::uint32_t at = start < cells.size() ? start : 0;
  if (t.is_ghost(at)) at = cells[at].neighbours[3] >> 2;
  for (;;) {
    if (t.is_ghost(at)) return {DelaunayLocation::Kind::outside, at, 0x7};
    const TriangulationCell& cell = cells[at];
    unsigned slots = 0;
    unsigned exit = 0;
    for (; exit < 4; ++exit) {
      const auto& [a, b, c] = facet_slots[exit];
      const Sign side = orientation(t.point(cell.vertices[a]), t.point(cell.vertices[b]), t.point(cell.vertices[c]), p);
      if (side == Sign::negative) break;
      if (side == Sign::positive) slots |= 1U << exit;
    }
    if (exit == 4) return {static_cast<DelaunayLocation::Kind>(std::popcount(slots) - 1), at, slots};
    at = cell.neighbours[exit] >> 2;
  }
}

std::uint32_t DelaunayLocator::nearest(const Point3& p) const {
  require_finite(p);
  const Delaunay3& t = triangulation_;
  const auto count = static_cast<std::uint32_t>(t.vertex_count());
  // As many samples as steps are saved by them.
  const auto samples = static_cast<std::uint32_t>(std::cbrt(static_cast<double>(count))) + 1;
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < samples; ++i) {
    const auto v = static_cast<std::uint32_t>(std::uint64_t{i} * count / samples);
    if (compare_distances(p, t.point(v), t.point(best)) < 0) best = v;
  }
  // The nearest of all is the one that no neighbour is nearer than; others as near share a Delone cell with it, and
  // are reached through neighbours that are as near.
  for (bool is_moving = true; is_moving;) {
    is_moving = false;
    for (const std::uint32_t v : stars_.neighbours(best)) {
      if (compare_distances(p, t.point(v), t.point(best)) < 0) {
        best = v;
        is_moving = true;
      }
    }
  }
  std::vector<std::uint32_t> ties{best};
  std::unordered_set<std::uint32_t> is_tied{best};
  for (std::size_t k = 0; k < ties.size(); ++k) {
    for (const std::uint32_t v : stars_.neighbours(ties[k])) {
      if (is_tied.count(v) != 0 || compare_distances(p, t.point(v), t.point(best)) != 0) continue;
      is_tied.insert(v);
      ties.push_back(v);
    }
  }
  return *std::min_element(ties.begin(), ties.end());
}

}  // namespace quoin
