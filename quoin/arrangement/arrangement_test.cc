// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/arrangement.h"

#include <gtest/gtest.h>

#include <random>

#include "quoin/arrangement/linear/linear_arrangement.h"

namespace quoin {
namespace {

TEST(Arrangement, EmptyHasOneFace) {
  const LinearArrangement empty;
  EXPECT_EQ(empty.counts().faces, 1U);
  dcel::check_links(empty.cells());
}

TEST(Arrangement, LinesInGeneralPosition) {
  for (const std::size_t n : {1U, 2U, 3U, 10U, 40U}) {
    LinearFamily family;
    PieceList<LinearFamily> list;
    for (std::size_t i = 0; i < n; ++i) {
      const auto t = static_cast<double>(i);
      family.add_line(list, {0, t * t}, {1, t * t + t}, "line");
    }
    const LinearArrangement lines = arrange(std::move(family), list, Context());
    dcel::check_links(lines.cells());
    const dcel::Counts counts = lines.counts();
    EXPECT_EQ(counts.vertices, n * (n - 1) / 2);
    EXPECT_EQ(counts.edges, n * n);
    EXPECT_EQ(counts.faces, 1 + n + n * (n - 1) / 2);
  }
}

TEST(Arrangement, SegmentsOnTinyGrids) {
  std::mt19937 random(7);
  for (int round = 0; round < 3000; ++round) {
    const int size = 2 + round % 5;
    const int count = 1 + round % 23;
    LinearFamily family;
    PieceList<LinearFamily> list;
    const auto pick = [&] { return static_cast<double>(random() % static_cast<unsigned>(size)); };
    for (int i = 0; i < count; ++i) {
      const Point2 a{pick(), pick()};
      const Point2 b{pick(), pick()};
      if (a == b) {
        family.add_point(list, a);
      } else if (round % 3 == 0 && i % 3 == 0) {
        family.add_ray(list, a, b);
      } else {
        family.add_segment(list, a, b);
      }
    }
    const LinearArrangement grid = arrange(std::move(family), list, Context());
    ASSERT_NO_THROW(dcel::check_links(grid.cells())) << round;
  }
}

}  // namespace
}  // namespace quoin
