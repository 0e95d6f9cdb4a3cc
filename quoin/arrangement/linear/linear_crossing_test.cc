// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/linear/linear_family.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace quoin {
namespace {

/// Thirds and sevenths of integers up to about 2^(3 + spread), sometimes moved by next to nothing.
Rational coordinate(std::mt19937& random, int spread) {
  const int magnitude = 8 << (random() % static_cast<unsigned>(spread + 1));
  const int value = static_cast<int>(random() % static_cast<unsigned>(2 * magnitude)) - magnitude;
  Rational result(Integer(value), Integer(random() % 2 == 0 ? 3 : 7));
  if (random() % 4 == 0) result += Rational(std::ldexp(1.0, -20 - static_cast<int>(random() % 60)));
  return result;
}

TEST(LinearCrossing, CrossingsOfRationalLinesAreWithinTheirError) {
  std::mt19937 random(17);
  int crossings = 0;
  for (int round = 0; round < 4000; ++round) {
    const int spread = round % 15;
    const auto point = [&] { return RationalPoint2{coordinate(random, spread), coordinate(random, spread)}; };
    const RationalPoint2 a = point();
    const RationalPoint2 b = point();
    RationalPoint2 c = point();
    RationalPoint2 d = point();
    if (round % 3 == 0) {  // nearly parallel
      const Rational nudge(std::ldexp(1.0, -5 - round % 60));
      d = {c.x + b.x - a.x, c.y + b.y - a.y + nudge};
    }
    if (round % 5 == 0) c = a;
    if (a == b || c == d) continue;
    LinearFamily family;
    const BranchId first = family.add_line(a, b);
    const BranchId second = family.add_line(c, d);
    if (family.compare_slopes(first, second) == Sign::zero) continue;
    ++crossings;
    const LinearPoint p = family.crossing(first, second);
    const RationalPoint2 exact = family.exact(p);
    const double size = std::max(std::fabs(p.x), std::fabs(p.y));
    const Rational error(std::max(family.error(), 0x1p-46 * size));
    ASSERT_LE(abs(exact.x - Rational(p.x)), error) << "round " << round;
    ASSERT_LE(abs(exact.y - Rational(p.y)), error) << "round " << round;
    ASSERT_EQ(family.compare_y_at_x(p, first), Sign::zero);
    ASSERT_EQ(family.compare_y_at_x(p, second), Sign::zero);
  }
  EXPECT_GT(crossings, 3000);
}

}  // namespace
}  // namespace quoin
