// SPDX-License-Identifier: Apache-2.0
//
// Sums of many polytopes against the hull of all sums of their vertices, in any order; mixed volumes.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "quoin/base/test_rounds.h"
#include "quoin/polytope/convex_boundary.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/test_sums.h"
#include "quoin/solid/measure.h"

namespace quoin {
namespace {

using namespace test_polytopes;

std::vector<Polytope> polytopes_of(const std::vector<Points>& summands) {
  std::vector<Polytope> result;
  for (const Points& points : summands) result.push_back(Polytope::hull_of(points, one_thread));
  return result;
}

/// The facets as rings of tuples, from the smallest, for summands in the order given.
std::set<std::vector<std::vector<std::uint32_t>>> tuples_of(const PolytopeSumOfMany& sum,
                                                            const std::vector<std::size_t>& order) {
  std::set<std::vector<std::vector<std::uint32_t>>> facets;
  for (std::size_t f = 0; f < sum.facet_count(); ++f) {
    std::vector<std::vector<std::uint32_t>> facet;
    for (const std::uint32_t v : sum.facet(f)) {
      std::vector<std::uint32_t> tuple(order.size());
      for (std::size_t i = 0; i < order.size(); ++i) tuple[order[i]] = sum.vertex(v)[i];
      facet.push_back(tuple);
    }
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
    facets.insert(facet);
  }
  return facets;
}

TEST(SumOfMany, OfRandomPolytopesInAnyOrder) {
  std::array<int, 4> seen{};
  for (std::uint64_t seed = 0; seed < test_rounds(1500U); ++seed) {
    Random random(seed);
    std::vector<Points> summands;
    const int count = 1 + below(random, 4);
    for (int i = 0; i < count; ++i) {
      const bool is_multiple = i > 0 && below(random, 6) == 0;
      const auto other = static_cast<std::size_t>(below(random, std::max(i, 1)));
      Points points = on_a_small_flat(random, (count > 3 ? 1 : 0) + below(random, count > 3 ? 2 : 4));
      summands.push_back(is_multiple ? scaled(summands[other], below(random, 2) == 0 ? -1 : 2) : points);
    }
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::vector<Polytope> polytopes = polytopes_of(summands);
    const PolytopeSumOfMany sum = minkowski_sum(polytopes, one_thread);
    const Cells expected = cells_of_hull(all_sums(summands));
    ASSERT_EQ(cells_of_sum(sum, exact_vertices(sum, polytopes)), expected);
    ASSERT_EQ(sum.vertex_count(), expected.vertices.size());
    ++seen.at(static_cast<std::size_t>(sum.dimension));
    std::vector<std::size_t> order(summands.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto tuples = tuples_of(sum, order);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<Polytope> shuffled;
    for (const std::size_t i : order) shuffled.push_back(polytopes[i]);
    ASSERT_EQ(tuples_of(minkowski_sum(shuffled, one_thread), order), tuples);
  }
  for (const int count : seen) EXPECT_GE(count, test_cases(20));
}

TEST(SumOfMany, OfNone) {
  const PolytopeSumOfMany sum = minkowski_sum(std::span<const Polytope>(), one_thread);
  EXPECT_EQ(sum.dimension, 0);
  EXPECT_EQ(sum.vertex_count(), 1U);
  EXPECT_EQ(exact_vertices(sum, {}), std::vector<RationalPoint3>({{0, 0, 0}}));
}

/// The zonotope of k segments of which no three are parallel to a plane has k (k - 1) parallelograms.
TEST(SumOfMany, OfSegmentsIsAZonotope) {
  for (std::uint64_t seed = 0; seed < test_rounds(10U); ++seed) {
    Random random(seed);
    std::normal_distribution<double> normal;
    std::vector<Points> segments;
    const std::size_t count = 3 + seed;
    // Of any doubles: their sums are none.
    for (std::size_t i = 0; i < count; ++i) {
      segments.push_back({{0, 0, 0}, {normal(random), normal(random), normal(random)}});
    }
    const PolytopeSumOfMany sum = minkowski_sum(polytopes_of(segments), one_thread);
    EXPECT_EQ(sum.facet_count(), count * (count - 1));
    EXPECT_EQ(sum.vertex_count(), count * (count - 1) + 2);
    EXPECT_EQ(sum.edge_count(), 2 * count * (count - 1));
  }
}

/// In general position, with coordinates whose sums are no doubles: support functions add.
TEST(SumOfMany, SupportFunctionsAdd) {
  Random random(5);
  std::normal_distribution<double> normal;
  std::vector<Points> summands(4);
  for (Points& points : summands) {
    for (int i = 0; i < 12; ++i) points.push_back({normal(random), normal(random), normal(random) * 1e-3});
  }
  const std::vector<Polytope> polytopes = polytopes_of(summands);
  const PolytopeSumOfMany sum = minkowski_sum(polytopes, one_thread);
  EXPECT_EQ(sum.vertex_count() + sum.facet_count(), sum.edge_count() + 2);
  const std::vector<RationalPoint3> vertices = exact_vertices(sum, polytopes);
  for (int i = 0; i < 30; ++i) {
    const RationalPoint3 direction{Rational(normal(random)), Rational(normal(random)), Rational(normal(random))};
    const auto reach = [&](const std::vector<RationalPoint3>& points) {
      Rational most = dot(direction, points[0]);
      for (const RationalPoint3& p : points) most = std::max(most, dot(direction, p));
      return most;
    };
    Rational expected(0);
    for (const Points& points : summands) {
      std::vector<RationalPoint3> exact;
      for (const Point3& p : points) exact.push_back(exact_point(p));
      expected += reach(exact);
    }
    EXPECT_EQ(reach(vertices), expected);
  }
}

Rational volume_of_sum(const std::vector<Polytope>& summands) {
  const PolytopeSumOfMany sum = minkowski_sum(summands, one_thread);
  if (sum.dimension < 3) return Rational(0);
  return volume(convex_boundary(exact_vertices(sum, summands), sum.corners, sum.facet_begin, "sum"), one_thread);
}

/// 6 V(P, Q, R), by inclusion and exclusion.
Rational mixed_volume(const Polytope& p, const Polytope& q, const Polytope& r) {
  return volume_of_sum({p, q, r}) - volume_of_sum({p, q}) - volume_of_sum({q, r}) - volume_of_sum({p, r}) +
         volume_of_sum({p}) + volume_of_sum({q}) + volume_of_sum({r});
}

TEST(MixedVolume, OfSegmentsIsADeterminant) {
  Random random(8);
  const Points origin{{0, 0, 0}};
  for (int i = 0; i < 60; ++i) {
    std::vector<Polytope> segments;
    std::vector<RationalPoint3> vectors;
    for (int k = 0; k < 3; ++k) {
      const double x = below(random, 5) - 2;
      const double y = below(random, 5) - 2;
      const Point3 end{x, y, double(below(random, 5) - 2)};
      segments.push_back(Polytope::hull_of(Points{origin[0], end}, one_thread));
      vectors.push_back(exact_point(end));
    }
    EXPECT_EQ(mixed_volume(segments[0], segments[1], segments[2]), abs(dot(vectors[0], cross(vectors[1], vectors[2]))));
  }
}

/// V(P + t Q) = V(P) + 3 t V(P, P, Q) + 3 t^2 V(P, Q, Q) + t^3 V(Q); and what is known of the coefficients: they do not
/// grow smaller with a summand, V(P, Q, R)^2 >= V(P, P, R) V(Q, Q, R) (Alexandrov and Fenchel), V(P, P, Q)^3 >=
/// V(P)^2 V(Q) (Minkowski).
TEST(MixedVolume, TheVolumeOfASumIsACubic) {
  for (std::uint64_t seed = 0; seed < test_rounds(120U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Points q_points = on_a_small_flat(random, 1 + below(random, 3));
    const Polytope p = Polytope::hull_of(on_a_small_grid(random, 4, 8), one_thread);
    const Polytope q = Polytope::hull_of(q_points, one_thread);
    const Polytope r = Polytope::hull_of(on_a_small_grid(random, 4, 4), one_thread);
    const Rational ppq = mixed_volume(p, p, q);
    const Rational pqq = mixed_volume(p, q, q);
    const Rational of_p = volume_of_sum({p});
    const Rational of_q = volume_of_sum({q});
    const Rational half(0.5);
    for (const double t : {1.0, 2.0, 0.375, 5.0}) {
      const Polytope tq = Polytope::hull_of(scaled(q_points, t), one_thread);
      const Rational s(t);
      EXPECT_EQ(volume_of_sum({p, tq}), of_p + s * ppq * half + s * s * pqq * half + s * s * s * of_q);
    }
    EXPECT_EQ(mixed_volume(p, p, p), of_p * Rational(6));
    const Rational six(6);
    EXPECT_GE(ppq * ppq * ppq, six * six * six * of_p * of_p * of_q);
    const Rational pqr = mixed_volume(p, q, r);
    EXPECT_EQ(pqr, mixed_volume(r, p, q));
    EXPECT_GE(pqr * pqr, mixed_volume(p, p, r) * mixed_volume(q, q, r));
    EXPECT_NE(pqr.sign(), Sign::negative);
  }
}

}  // namespace
}  // namespace quoin
