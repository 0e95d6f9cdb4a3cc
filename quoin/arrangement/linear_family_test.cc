// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/linear_family.h"

#include <gtest/gtest.h>

<<<<<<< HEAD
#include <random>
#include <sstream>

#include "quoin/arrangement/family_suite.h"
=======
#include <algorithm>
#include <cmath>
#include <random>
>>>>>>> 79700b3 (Near-degenerate sums of doubles and certified crossings of rational lines under test)

namespace quoin {
namespace {

<<<<<<< HEAD
TEST(LinearFamily, KeepsTheLawsOnTinyGrids) {
  std::mt19937 random(1);
  testing::FamilyCases cases;
  LinearFamily previous;
  for (int round = 0; round < 400; ++round) {
    LinearFamily family;
    PieceList<LinearFamily> list;
    PieceList<LinearFamily> backwards;
    std::ostringstream log;
    bool segments_only = true;
    for (int i = 0; i < 7; ++i) {
      const auto pick = [&] { return static_cast<double>(random() % 6); };
      const Point2 a{pick(), pick()};
      const Point2 b{random() % 4 == 0 ? a.x : pick(), pick()};
      if (a == b) continue;
      const unsigned kind = random() % 4;
      log << kind << ": " << a.x << ' ' << a.y << ", " << b.x << ' ' << b.y << '\n';
      if (kind == 2) family.add_ray(list, a, b);
      if (kind == 3) family.add_line(list, a, b, "line");
      if (kind > 1) segments_only = false;
      if (kind < 2) family.add_segment(list, a, b);
      if (kind < 2) family.add_segment(backwards, b, a);
    }
    SCOPED_TRACE("round " + std::to_string(round) + "\n" + log.str());
    testing::check_family_laws(family, list, &cases, &previous);
    previous = family;
    if (segments_only) testing::check_reversed(family, list, backwards);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(cases.vertical, 100U);
  EXPECT_GT(cases.overlapping, 50U);
  EXPECT_GT(cases.common_end, 100U);
  EXPECT_GT(cases.multiple, 50U);
  EXPECT_GT(cases.reversed, 100U);
  EXPECT_GT(cases.met_by_sweep, 100U);
=======
/// Thirds and sevenths of integers up to about 2^(3 + spread), sometimes moved by next to nothing.
Rational coordinate(std::mt19937& random, int spread) {
  const int magnitude = 8 << (random() % static_cast<unsigned>(spread + 1));
  const int value = static_cast<int>(random() % static_cast<unsigned>(2 * magnitude)) - magnitude;
  Rational result(Integer(value), Integer(random() % 2 == 0 ? 3 : 7));
  if (random() % 4 == 0) result += Rational(std::ldexp(1.0, -20 - static_cast<int>(random() % 60)));
  return result;
}

TEST(LinearFamily, CrossingsOfRationalLinesAreWithinTheirError) {
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
>>>>>>> 79700b3 (Near-degenerate sums of doubles and certified crossings of rational lines under test)
}

}  // namespace
}  // namespace quoin
