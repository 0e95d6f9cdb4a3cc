// SPDX-License-Identifier: Apache-2.0
//
// Bounds of distances of triangles in doubles against rationals, and searches for near pairs against all pairs.
#include "quoin/solid/query/triangle_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/number/rational.h"
#include "quoin/solid/box_tree.h"

namespace quoin {
namespace {

using closest::SquaredBounds;
using closest::Triangle;
using closest::TrianglePair;
using closest::Vector;
using Random = std::mt19937_64;

Triangle<Rational> exact(const Triangle<double>& t) {
  Triangle<Rational> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) result[i][axis] = Rational(t[i][axis]);
  }
  return result;
}

bool is_flat(const Triangle<double>& t) {
  const Triangle<Rational> e = exact(t);
  const auto n = closest::cross(closest::difference(e[1], e[0]), closest::difference(e[2], e[0]));
  return closest::dot(n, n).sign() == Sign::zero;
}

Rational exact_square(const Triangle<double>& a, const Triangle<double>& b) {
  TrianglePair<Rational> pair(exact(a), exact(b));
  return pair.common_point() ? Rational(0) : pair.nearest().squared_length;
}

void expect_bounds(const Triangle<double>& a, const Triangle<double>& b, int& decided) {
  const SquaredBounds bounds = closest::squared_bounds(a, b, 0);
  const Rational square = exact_square(a, b);
  EXPECT_LE(Rational(bounds.lower), square);
  if (std::isfinite(bounds.upper)) {
    EXPECT_GE(Rational(bounds.upper), square);
  }
  const bool is_close = bounds.lower > 0 && bounds.upper - bounds.lower < 1e-9 * bounds.upper;
  decided += is_close ? 1 : 0;
}

TEST(TriangleDistance, BoundsHoldOnSmallGridsAndClose) {
  int decided = 0;
  int pairs = 0;
  for (std::uint64_t seed = 0; seed < test_rounds(3000U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto draw = [&](double away) {
      Triangle<double> t;
      for (Vector<double>& p : t) {
        for (double& x : p) x = seed % 2 == 0 ? static_cast<double>(random() % 4) : unit(random);
        p[0] += away;
      }
      return t;
    };
    Triangle<double> a = draw(0);
    Triangle<double> b = draw(static_cast<double>(random() % 5));
    if (seed % 5 == 4) b[0] = {std::nextafter(a[0][0], 9), a[0][1], a[0][2]};
    if (seed % 7 == 6) a[2] = {a[1][0] + (a[1][0] - a[0][0]) * 3, a[1][1], a[1][2] + 0x1p-40};  // a sliver, mostly
    if (is_flat(a) || is_flat(b)) continue;
    ++pairs;
    expect_bounds(a, b, decided);
    if (HasFailure()) return;
  }
  EXPECT_GE(decided, test_cases(pairs / 3));
}

/// Beyond 2^+-200 they say nothing.
TEST(TriangleDistance, BoundsHoldAtAnySize) {
  for (const double size : {0x1p-1000, 0x1p-195, 0x1p-100, 0x1p100, 0x1p195, 0x1p1000}) {
    Triangle<double> a{{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}};
    Triangle<double> b{{{0, 0, size}, {size, 0, 3 * size}, {0, size, 2 * size}}};
    int decided = 0;
    expect_bounds(a, b, decided);
    EXPECT_EQ(decided, 0x1p-200 < size && size < 0x1p200 ? 1 : 0);
  }
}

TEST(TriangleDistance, CommonPointsThatCrossAreTold) {
  const Triangle<double> floor{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  const auto crossing = [&](const Triangle<double>& t) {
    const auto common = TrianglePair<Rational>(exact(floor), exact(t)).common_point();
    return common ? (common->is_crossing ? 2 : 1) : 0;
  };
  EXPECT_EQ(crossing({{{1, 1, -1}, {1, 1, 1}, {9, 9, 9}}}), 2);
  EXPECT_EQ(crossing({{{2, 2, -1}, {2, 2, 1}, {9, 9, 9}}}), 1);
  EXPECT_EQ(crossing({{{0, 0, -1}, {0, 0, 1}, {-9, -9, 9}}}), 1);
  EXPECT_EQ(crossing({{{3, 3, -1}, {3, 3, 1}, {9, 9, 9}}}), 0);
  EXPECT_EQ(crossing({{{1, 1, 0}, {1, 1, 1}, {9, 9, 9}}}), 0);
}

/// Corners that are off by 2^-53 of themselves.
TEST(TriangleDistance, BoundsHoldForRoundedCorners) {
  Random random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int round = 0; round < test_rounds(400); ++round) {
    Triangle<Rational> a;
    Triangle<Rational> b;
    Triangle<double> rounded_a;
    Triangle<double> rounded_b;
    const double away = round % 2 == 0 ? 0 : 1e6;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        a[i][axis] = Rational(away + unit(random)) / Rational(3);
        b[i][axis] = Rational(away + unit(random) + (axis == 0 ? 3.0 : 0.0)) / Rational(3);
        rounded_a[i][axis] = a[i][axis].to_double();
        rounded_b[i][axis] = b[i][axis].to_double();
      }
    }
    TrianglePair<Rational> pair(a, b);
    const Rational square = pair.common_point() ? Rational(0) : pair.nearest().squared_length;
    const SquaredBounds bounds = closest::squared_bounds(rounded_a, rounded_b, 0x1p-53 * (away + 2));
    EXPECT_LE(Rational(bounds.lower), square);
    EXPECT_GE(Rational(bounds.upper), square);
    EXPECT_GT(bounds.lower, 0);
  }
}

TEST(BoxTreeNearest, FindsTheNearestBoxesAndLeavesMostOut) {
  const Context context({.threads = 1});
  Random random(5);
  std::uniform_real_distribution<float> unit(0, 1);
  const auto boxes = [&](std::size_t count, float away) {
    std::vector<FloatBox> result;
    for (std::size_t i = 0; i < count; ++i) {
      const std::array<float, 3> lo{unit(random) * 10 + away, unit(random) * 10, unit(random) * 10};
      result.push_back({lo, {lo[0] + unit(random), lo[1] + unit(random), lo[2] + unit(random)}});
    }
    return result;
  };
  const auto gap = [](const FloatBox& a, const FloatBox& b) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = std::max({0.0, double(b.lo[k]) - double(a.hi[k]), double(a.lo[k]) - double(b.hi[k])});
      sum += d * d;
    }
    return sum;
  };
  for (const float away : {0.0F, 12.0F}) {
    const std::vector<FloatBox> a = boxes(300, 0);
    const std::vector<FloatBox> b = boxes(170, away);
    const BoxTree tree_a(a, context);
    const BoxTree tree_b(b, context);
    std::set<std::pair<std::uint32_t, std::uint32_t>> all;
    const auto no_bound = [&](const TilePair& pair) {
      EXPECT_TRUE(all.insert({pair.a, pair.b}).second);
      return std::numeric_limits<double>::infinity();
    };
    BoxTree::nearest_pairs(tree_a, tree_b, {}, no_bound, context);
    EXPECT_EQ(all.size(), a.size() * b.size());
    double least = std::numeric_limits<double>::infinity();
    for (const FloatBox& x : a) {
      for (const FloatBox& y : b) least = std::min(least, gap(x, y));
    }
    double found = std::numeric_limits<double>::infinity();
    std::size_t visits = 0;
    const auto nearer = [&](const TilePair& pair) {
      ++visits;
      found = std::min(found, gap(a[pair.a], b[pair.b]));
      return found;
    };
    BoxTree::nearest_pairs(tree_a, tree_b, {}, nearer, context);
    EXPECT_EQ(found, least);
    EXPECT_LT(visits, all.size() / 4);
    visits = 0;
    const auto first_only = [&](const TilePair&) {
      ++visits;
      return -1.0;
    };
    BoxTree::nearest_pairs(tree_a, tree_b, {}, first_only, context);
    EXPECT_EQ(visits, 1U);
  }
  BoxTree::nearest_pairs(
      BoxTree(), BoxTree(), {}, [](const TilePair&) -> double { throw InternalError("there are no pairs"); }, context);
}

}  // namespace
}  // namespace quoin
