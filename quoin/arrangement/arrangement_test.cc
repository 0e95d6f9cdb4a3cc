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

// Book on arrangements, 3.3.
TEST(Arrangement, GridsOfLongSegments) {
  for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{1, 1}, {2, 3}, {7, 5}, {20, 30}}) {
    LinearFamily family;
    PieceList<LinearFamily> list;
    for (std::size_t i = 1; i <= a; ++i) {
      family.add_segment(list, Point2{static_cast<double>(i), 0},
                         Point2{static_cast<double>(i), static_cast<double>(b + 1)});
    }
    for (std::size_t j = 1; j <= b; ++j) {
      family.add_segment(list, Point2{0, static_cast<double>(j)},
                         Point2{static_cast<double>(a + 1), static_cast<double>(j)});
    }
    const LinearArrangement grid = arrange(std::move(family), list, Context());
    dcel::check_links(grid.cells());
    EXPECT_EQ(grid.counts().vertices, a * b + 2 * (a + b));
    EXPECT_EQ(grid.counts().faces, (a - 1) * (b - 1) + 1);
  }
}

TEST(Arrangement, ConcurrentLines) {
  for (const std::size_t n : {2U, 3U, 10U, 200U}) {
    LinearFamily family;
    PieceList<LinearFamily> list;
    for (std::size_t i = 0; i < n; ++i) {
      // All on x + y = 1, by other points each.
      const auto t = static_cast<double>(i) + 1;
      family.add_line(list, Point2{-t, 1 + t}, Point2{2 * t + 1, -2 * t}, "line");
    }
    const LinearArrangement lines = arrange(std::move(family), list, Context());
    dcel::check_links(lines.cells());
    // One line; and n lines through (1/3, 1/3), which is no pair of doubles.
    EXPECT_EQ(lines.counts().vertices, 0U);
    EXPECT_EQ(lines.counts().faces, 2U);
    LinearFamily turned_family;
    PieceList<LinearFamily> turned;
    for (std::size_t i = 0; i < n; ++i) {
      const auto t = static_cast<double>(i) + 1;
      const Rational third(Integer(1), Integer(3));
      const RationalPoint2 centre{third, third};
      const BranchId line = turned_family.add_line(centre, RationalPoint2{third + Rational(1), third + Rational(t)});
      turned.pieces.push_back({line, turned.add_point(turned_family.first_end(line)),
                               turned.add_point(turned_family.last_end(line)), CurveId(i), false});
    }
    turned.curve_count = static_cast<std::uint32_t>(n);
    const LinearArrangement pencil = arrange(std::move(turned_family), turned, Context());
    dcel::check_links(pencil.cells());
    EXPECT_EQ(pencil.counts().vertices, 1U);
    EXPECT_EQ(pencil.counts().edges, 2 * n);
    EXPECT_EQ(pencil.counts().faces, 2 * n);
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
