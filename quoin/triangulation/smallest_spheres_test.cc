// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/smallest_spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "quoin/base/test_rounds.h"
#include "quoin/kernel/test_points.h"
#include "quoin/triangulation/exact_ranks.h"
#include "quoin/triangulation/test_spheres.h"

namespace quoin {
namespace {

using testing::Family;
using testing::PowerSphere;
using testing::Random;
using testing::SlowSpheres;

/// Nearly coplanar, nearly on the sphere of others, or of any shape.
std::array<Point3, 4> four_points(Random& random, const Family& family) {
  std::array<Point3, 4> p;
  for (Point3& q : p) q = testing::make_point(&q, random, family.coordinate);
  if (random() % 3 == 0) {
    for (std::size_t axis = 0; axis < 3; ++axis) p[3][axis] = p[0][axis] / 2 + p[1][axis] / 2;
  }
  if (random() % 3 == 0) {
    // The fourth corner of a rectangle, or nearly.
    for (std::size_t axis = 0; axis < 3; ++axis) p[3][axis] = p[0][axis] - p[1][axis] / 2 + p[2][axis] / 2;
    p[static_cast<std::size_t>(random() % 4)][static_cast<std::size_t>(random() % 3)] += std::ldexp(1.0, -40);
  }
  for (Point3& q : p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(q[axis])) q[axis] = 1;
    }
  }
  return p;
}

void expect_power(const SmallestSpheres& spheres, const PowerSphere& slow) {
  ASSERT_EQ(spheres.exact_power(slow.vertices).rational(), slow.power);
  ASSERT_TRUE(spheres.power(slow.vertices).contains(slow.power));
  ASSERT_TRUE(spheres.close_power(slow.vertices).contains(slow.power));
  ASSERT_EQ(spheres.nearest_power(slow.vertices), slow.power.to_double());
  ASSERT_EQ(compare(spheres.exact_power(slow.vertices), spheres.exact_power(slow.vertices)), Sign::zero);
}

void expect_sides(const SmallestSpheres& spheres, const SlowSpheres& slow, const PowerSphere& all) {
  const std::size_t n = all.vertices.size();
  for (std::size_t j = 0; n > 1 && j < n; ++j) {
    testing::Subset facet = all.vertices;
    facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(j));
    const auto of_facet = std::find_if(slow.spheres().begin(), slow.spheres().end(),
                                       [&](const PowerSphere& s) { return s.vertices == facet; });
    const Rational excess = slow.power(of_facet->centre, all.vertices[j]) - of_facet->power;
    ASSERT_EQ(spheres.side(facet, all.vertices[j]), excess.sign());
    if (n < 4) continue;
    const auto& v = all.vertices;
    ASSERT_EQ(spheres.cell({v[0], v[1], v[2], v[3]}).side[j], excess.sign());
  }
}

TEST(SmallestSpheres, AreThoseOfRationals) {
  Random random(1);
  for (const Family& family : testing::families()) {
    SCOPED_TRACE(family.name);
    for (int round = 0; round < test_rounds(10); ++round) {
      const std::array<Point3, 4> p = four_points(random, family);
      SCOPED_TRACE(testing::reproduce(p));
      std::vector<double> weights;
      if (round % 2 == 1) {
        const double size = std::min(std::fabs(p[1].x), 1e150);
        for (int i = 0; i < 4; ++i) weights.push_back(size * size * family.coordinate(random));
        for (double& w : weights) w = std::isfinite(w) ? w : 1;
      }
      const SmallestSpheres spheres({p.begin(), p.end()}, weights);
      const SlowSpheres slow(p, weights);
      for (const PowerSphere& s : slow.spheres()) {
        expect_power(spheres, s);
        expect_sides(spheres, slow, s);
      }
    }
  }
}

/// Numbers known by intervals of all widths, many of them equal.
TEST(ExactRanks, AreThoseOfTheNumbers) {
  Random random(2);
  for (int round = 0; round < test_rounds(60); ++round) {
    std::vector<Rational> numbers;
    const std::size_t count = random() % 200;
    for (std::size_t i = 0; i < count; ++i) {
      const double steps = testing::small_integer(random, 30);
      const Rational base = round % 3 == 0 ? Rational(0) : Rational(1) / Rational(3);
      const int shift = round % 2 == 0 ? -60 : round % 5 == 0 ? -300 : -3;
      numbers.push_back(base + Rational(std::ldexp(steps, shift)));
    }
    std::vector<Interval> bounds;
    for (const Rational& x : numbers) {
      const Interval tight = Interval::around(x);
      const double more = random() % 3 == 0 ? 0 : std::ldexp(1.0, -static_cast<int>(random() % 80));
      bounds.push_back(more == 0 ? tight : Interval(tight.lower() - more, tight.upper() + more));
    }
    const NumberSource source{[&](std::uint32_t i) { return Interval::around(numbers[i]); },
                              [&](std::uint32_t i) {
                                return ExactQuotient{numbers[i].numerator(), numbers[i].denominator(), 0};
                              }};
    const ExactRanks ranks = exact_ranks(bounds, source, Context({.threads = 1}));
    std::vector<Rational> sorted = numbers;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    ASSERT_EQ(ranks.first.size(), sorted.size());
    for (std::uint32_t i = 0; i < numbers.size(); ++i) {
      ASSERT_EQ(sorted[ranks.rank[i]], numbers[i]);
      ASSERT_LE(ranks.first[ranks.rank[i]], i);
      ASSERT_EQ(numbers[ranks.first[ranks.rank[i]]], numbers[i]);
    }
    std::vector<std::uint32_t> order(numbers.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return numbers[a] < numbers[b]; });
    ASSERT_EQ(ranks.order(), order);
  }
}

}  // namespace
}  // namespace quoin
