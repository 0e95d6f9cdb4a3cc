// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/linear/linear_family.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "quoin/arrangement/family_suite.h"

namespace quoin {
namespace {

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
}

}  // namespace
}  // namespace quoin
