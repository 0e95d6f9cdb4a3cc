// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/maximal_sums.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/polytope/minkowski_sum.h"

namespace quoin {

namespace {

using Points = std::vector<RationalPoint3>;

/// ((1 - t^2) / (1 + t^2), 2 t / (1 + t^2)).
RationalPoint2 on_circle(const Rational& t) {
  const Rational square = t * t;
  return {(Rational(1) - square) / (Rational(1) + square), Rational(2) * t / (Rational(1) + square)};
}

struct Narrowness {
  Rational slope;     ///< of the second polygon
  Rational crowding;  ///< of the vertices between the ridge and the sides, as a part of their way
};

/// Of four facets: an edge along the x axis, and one that is short and flatter still.
Points thin_tetrahedron(const Rational& slope) {
  const RationalPoint2 turn = on_circle(slope);
  const Rational height = slope / Rational(64);
  return {{1, 0, 0}, {-turn.y, -turn.x, 0}, {-1, 0, -height}, {turn.y, -turn.x, -height}};
}

/// The vertex, and its partner in the second polygon.
void add_pair(Points& points, const RationalPoint2& v, const Rational& ridge, const Rational& slope) {
  points.push_back({v.x, v.y, 0});
  // From the pole (0, p) to v: the product of the parameters of both points of the circle, that of v being 1, is
  // (p^2 - 1) / |v - pole|^2.
  const Rational p = Rational(1) / ridge;
  const Rational dy = v.y - p;
  const Rational t = (p * p - Rational(1)) / (v.x * v.x + dy * dy);
  const Rational y = p + t * dy;
  points.push_back({v.x * t, y, slope * (y - ridge)});
}

Points points_of_summand(std::size_t facet_count, const Narrowness& how) {
  if (facet_count == 4) return thin_tetrahedron(how.slope);
  const Rational t0(-0.5);
  const RationalPoint2 start = on_circle(t0);
  const std::size_t right = (facet_count - 2) / 2;  // edges from the ridge to (1, 0)
  const std::size_t left = facet_count - 3 - right;
  Points points{{start.x, start.y, 0}, {-start.x, start.y, 0}};
  for (const auto& [count, side] : {std::pair{right, 1}, std::pair{left, -1}}) {
    for (std::size_t k = 1; k <= count; ++k) {
      const Rational part(static_cast<std::int64_t>(k));
      const Rational way = part * how.crowding / Rational(static_cast<std::int64_t>(count));
      const RationalPoint2 v = on_circle(k < count ? t0 * (Rational(1) - way) : Rational(0));
      add_pair(points, {v.x * Rational(side), v.y}, start.y, how.slope);
    }
  }
  return points;
}

/// About the z axis by the angle with this tangent of its half.
Points leant(Points points, const Rational& tangent) {
  const RationalPoint2 turn = on_circle(tangent);
  for (RationalPoint3& p : points) p = {turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y, p.z};
  return points;
}

/// About the y axis by nearly i / k of half a turn; exactly where that is a quarter.
Points turned(Points points, std::size_t i, std::size_t k) {
  constexpr double quarter = 1.57079632679489661923;
  const double half_angle = quarter * static_cast<double>(i) / static_cast<double>(k);
  const RationalPoint2 turn = on_circle(Rational(std::round(std::tan(half_angle) * 0x1p20) * 0x1p-20));
  for (RationalPoint3& p : points) p = {turn.x * p.x + turn.y * p.z, p.y, turn.x * p.z - turn.y * p.x};
  return points;
}

void require_four(std::span<const std::size_t> facet_counts) {
  for (const std::size_t count : facet_counts) {
    if (count < 4) throw InputError("a solid polytope has four facets or more, not " + std::to_string(count));
  }
}

}  // namespace

std::size_t most_facets_of_sum(std::span<const std::size_t> facet_counts) {
  require_four(facet_counts);
  std::size_t result = 0;
  std::size_t before = 0;  // sum of 2 m - 5
  for (std::size_t i = 0; i < facet_counts.size(); ++i) {
    const std::size_t more = 2 * facet_counts[i] - 5;
    result += before * more + facet_counts[i] + i;
    before += more;
  }
  return result;
}

std::vector<Polytope> maximal_summands(std::span<const std::size_t> facet_counts, const Context& context) {
  const std::size_t most = most_facets_of_sum(facet_counts);
  constexpr int tries = 12;
  Narrowness how{Rational(1) / Rational(256), Rational(1)};
  for (int i = 0; i < tries; ++i) {
    std::vector<Polytope> summands;
    for (std::size_t k = 0; k < facet_counts.size(); ++k) {
      Points points = points_of_summand(facet_counts[k], how);
      // Else the arcs of edges perpendicular to the y axis would all cross in its two directions.
      points = leant(std::move(points), how.slope * Rational(static_cast<std::int64_t>(k * k)) / Rational(4));
      summands.push_back(Polytope::hull_of(turned(std::move(points), k, facet_counts.size()), context));
    }
    if (minkowski_sum(summands, context).facet_count() == most) return summands;
    how = {how.slope / Rational(8), how.crowding / Rational(4)};
  }
  throw InternalError("no polytopes were found whose sum has " + std::to_string(most) + " facets");
}

}  // namespace quoin
