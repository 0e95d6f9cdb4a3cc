// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/circular/circular_arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>
#include <vector>

#include "quoin/base/disjoint_sets.h"

namespace quoin {
namespace {

using Pieces = CircularFamily::Pieces;

struct CellCounts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  friend bool operator==(const CellCounts&, const CellCounts&) = default;
  friend std::ostream& operator<<(std::ostream& out, const CellCounts& c) {
    return out << c.vertices << " vertices, " << c.edges << " edges, " << c.faces << " faces";
  }
};

/// Of an arrangement in the plane, from all pairs of pieces: points are ends and common points, edges the steps between
/// neighbouring points that some piece of a branch covers, faces by Euler's formula.
CellCounts count_cells(const CircularFamily& family, const Pieces& list) {
  const auto before = [&](const CircularPoint& p, const CircularPoint& q) {
    return family.compare_xy(p, q) == Sign::negative;
  };
  std::vector<CircularPoint> points = list.points;
  for (std::size_t i = 0; i < list.pieces.size(); ++i) {
    for (std::size_t j = i + 1; j < list.pieces.size(); ++j) {
      const Piece& a = list.pieces[i];
      const Piece& b = list.pieces[j];
      if (family.same_branch(a.branch, b.branch)) continue;
      std::vector<Meeting<CircularPoint>> common;
      family.meetings(a.branch, b.branch, common);
      for (const auto& meeting : common) {
        const CircularPoint& p = meeting.point;
        if (before(p, list.points[a.left]) || before(list.points[a.right], p)) continue;
        if (before(p, list.points[b.left]) || before(list.points[b.right], p)) continue;
        points.push_back(p);
      }
    }
  }
  std::sort(points.begin(), points.end(), before);
  const auto equal = [&](const CircularPoint& p, const CircularPoint& q) {
    return family.compare_xy(p, q) == Sign::zero;
  };
  points.erase(std::unique(points.begin(), points.end(), equal), points.end());

  DisjointSets components(points.size());
  std::size_t edges = 0;
  std::vector<bool> done(list.pieces.size(), false);
  for (std::size_t i = 0; i < list.pieces.size(); ++i) {
    if (done[i]) continue;
    std::vector<Piece> same;
    for (std::size_t j = i; j < list.pieces.size(); ++j) {
      if (!family.same_branch(list.pieces[i].branch, list.pieces[j].branch)) continue;
      done[j] = true;
      same.push_back(list.pieces[j]);
    }
    std::size_t previous = points.size();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const CircularPoint& p = points[k];
      bool on = false;
      bool continues = false;  // from the point before on this branch
      for (const Piece& piece : same) {
        if (before(p, list.points[piece.left]) || before(list.points[piece.right], p)) continue;
        if (family.compare_y_at_x(p, piece.branch) != Sign::zero) continue;
        on = true;
        continues = continues || before(list.points[piece.left], p);
      }
      if (!on) continue;
      if (continues) {
        ++edges;
        components.unite(static_cast<std::uint32_t>(previous), static_cast<std::uint32_t>(k));
      }
      previous = k;
    }
  }
  std::size_t roots = 0;
  for (std::size_t k = 0; k < points.size(); ++k) roots += components.find(static_cast<std::uint32_t>(k)) == k ? 1 : 0;
  return {points.size(), edges, 1 + roots + edges - points.size()};
}

void expect_same_cells(const CircularFamily& family, const Pieces& list) {
  const CellCounts expected = count_cells(family, list);
  const CircularArrangement arrangement = arrange(family, list, Context());
  ASSERT_NO_THROW(dcel::check_links(arrangement.cells()));
  const dcel::Counts counts = arrangement.counts();
  ASSERT_EQ((CellCounts{counts.vertices, counts.edges, counts.faces}), expected);
}

TEST(CircularArrangement, OneCircleAndTwo) {
  CircularFamily family;
  Pieces list;
  family.add_circle(list, Point2{0, 0}, 5);
  EXPECT_EQ(arrange(family, list, Context()).counts().faces, 2U);
  family.add_circle(list, Point2{6, 0}, 5);
  const dcel::Counts counts = arrange(family, list, Context()).counts();
  EXPECT_EQ(counts.vertices, 6U);
  EXPECT_EQ(counts.edges, 8U);
  EXPECT_EQ(counts.faces, 4U);
  family.add_circle(list, Point2{0, 0}, 5);  // again
  EXPECT_EQ(arrange(family, list, Context()).counts().edges, 8U);
}

TEST(CircularArrangement, TinyGridsAgreeWithAllPairs) {
  std::mt19937 random(11);
  const auto pick = [&](int low, int high) {
    return static_cast<double>(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)));
  };
  for (int round = 0; round < 600; ++round) {
    CircularFamily family;
    Pieces list;
    std::ostringstream log;
    const int count = 1 + round % 9;
    for (int i = 0; i < count; ++i) {
      const Point2 a{pick(0, 6), pick(0, 6)};
      const Point2 b{pick(0, 6), random() % 3 == 0 ? a.y : pick(0, 6)};
      const int kind = static_cast<int>(random() % 4);
      const double r = pick(1, 5);
      log << kind << ": " << a.x << ' ' << a.y << ", " << b.x << ' ' << b.y << ", " << r << '\n';
      if (kind <= 1) {
        family.add_circle(list, a, r);
      } else if (a == b) {
        family.add_point(list, a);
      } else if (kind == 2) {
        family.add_segment(list, a, b);
      } else {
        family.add_bulge_arc(list, a, b, 0.25 * (r - 3));
      }
    }
    SCOPED_TRACE("round " + std::to_string(round) + "\n" + log.str());
    expect_same_cells(family, list);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(CircularArrangement, RandomDoublesAgreeWithAllPairs) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> real(0, 1);
  for (int round = 0; round < 20; ++round) {
    CircularFamily family;
    Pieces list;
    for (int i = 0; i < 25; ++i) {
      const Point2 a{real(random), real(random)};
      const Point2 b{real(random), real(random)};
      if (i % 3 == 0) family.add_circle(list, a, 0.05 + 0.3 * real(random));
      if (i % 3 == 1) family.add_segment(list, a, b);
      if (i % 3 == 2) family.add_bulge_arc(list, a, b, 2 * real(random) - 1);
    }
    SCOPED_TRACE("round " + std::to_string(round));
    expect_same_cells(family, list);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace quoin
