// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sweep/sweep_queries.h"

#include <map>
#include <set>

#include "quoin/arrangement/edit/editing_test_support.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using namespace editing_test;

struct Place {
  Rational x;
  Rational y;
  bool operator<(const Place& other) const { return x != other.x ? x < other.x : y < other.y; }
};

bool contains(const GridCurve& c, const Place& p) {
  const Rational ax(c.a.x), ay(c.a.y), bx(c.b.x), by(c.b.y);
  if ((bx - ax) * (p.y - ay) != (by - ay) * (p.x - ax)) return false;
  return !(p.x < std::min(ax, bx)) && !(std::max(ax, bx) < p.x) && !(p.y < std::min(ay, by)) &&
         !(std::max(ay, by) < p.y);
}

/// Ends and crossings of supports, each with the segments through it.
std::map<Place, std::vector<std::uint32_t>> slow_intersections(const std::vector<GridCurve>& curves) {
  std::set<Place> places;
  for (const GridCurve& c : curves) {
    places.insert({Rational(c.a.x), Rational(c.a.y)});
    places.insert({Rational(c.b.x), Rational(c.b.y)});
    for (const GridCurve& d : curves) {
      const double dx = c.b.x - c.a.x, dy = c.b.y - c.a.y, ex = d.b.x - d.a.x, ey = d.b.y - d.a.y;
      const double det = dx * ey - dy * ex;
      if (det == 0) continue;
      const Rational t = Rational((d.a.x - c.a.x) * ey - (d.a.y - c.a.y) * ex) / Rational(det);
      const Place p{Rational(c.a.x) + t * Rational(dx), Rational(c.a.y) + t * Rational(dy)};
      if (contains(c, p) && contains(d, p)) places.insert(p);
    }
  }
  std::map<Place, std::vector<std::uint32_t>> result;
  for (const Place& p : places) {
    std::vector<std::uint32_t> through;
    for (std::uint32_t i = 0; i < curves.size(); ++i) {
      if (contains(curves[i], p)) through.push_back(i);
    }
    if (through.size() > 1) result[p] = through;
  }
  return result;
}

bool is_end(const GridCurve& c, const Place& p) {
  return (p.x == Rational(c.a.x) && p.y == Rational(c.a.y)) || (p.x == Rational(c.b.x) && p.y == Rational(c.b.y));
}

bool overlap(const GridCurve& c, const GridCurve& d) {
  int shared = 0;
  std::set<Place> ends;
  for (const GridCurve* one : {&c, &d}) {
    ends.insert({Rational(one->a.x), Rational(one->a.y)});
    ends.insert({Rational(one->b.x), Rational(one->b.y)});
  }
  for (const Place& p : ends) shared += static_cast<int>(contains(c, p) && contains(d, p));
  return shared > 1;
}

TEST(SweepQueries, EqualRationalPairs) {
  std::mt19937 random(23);
  for (int round = 0; round < test_rounds(1500); ++round) {
    std::vector<GridCurve> curves;
    LinearFamily family;
    PieceList<LinearFamily> list;
    for (int i = 0; i < 1 + round % 9; ++i) {
      curves.push_back(random_curve(random, {3 + round % 8, false, false}));
      add(family, list, curves.back());
    }
    const auto expected = slow_intersections(curves);
    IntersectionOptions options;
    options.includes_common_ends = true;
    const auto reported = report_intersections(family, list, Context(), options);
    ASSERT_EQ(reported.size(), expected.size()) << text(curves);
    auto at = expected.begin();
    bool crosses = false;
    for (const auto& one : reported) {
      const RationalPoint2 p = family.exact(one.point);
      ASSERT_TRUE(p.x == at->first.x && p.y == at->first.y) << text(curves);
      ASSERT_EQ(one.pieces, at->second) << text(curves);
      for (const std::uint32_t piece : at->second) crosses = crosses || !is_end(curves[piece], at->first);
      ++at;
    }
    for (std::size_t i = 0; i < curves.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) crosses = crosses || overlap(curves[i], curves[j]);
    }
    ASSERT_EQ(crosses_anything(family, list, Context()), crosses) << text(curves);
    ASSERT_EQ(report_intersections(family, list, Context()).empty(), !crosses) << text(curves);
  }
}

TEST(SweepQueries, SubCurvesAreTheEdges) {
  std::mt19937 random(29);
  for (int round = 0; round < 500; ++round) {
    std::vector<GridCurve> curves;
    LinearFamily family;
    PieceList<LinearFamily> list;
    for (int i = 0; i < 1 + round % 12; ++i) {
      curves.push_back(random_curve(random, {3 + round % 5, round % 2 == 0, false}));
      add(family, list, curves.back());
    }
    const auto parts = sub_curves(family, list, Context());
    const LinearArrangement arrangement = swept(curves);
    ASSERT_EQ(parts.size(), arrangement.counts().edges) << text(curves);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const dcel::EdgeId e(i);
      ASSERT_EQ(family.compare_xy(parts[i].left, arrangement.left_point(e)), Sign::zero) << text(curves);
      ASSERT_EQ(family.compare_xy(parts[i].right, arrangement.right_point(e)), Sign::zero) << text(curves);
      const auto uses = arrangement.curves(e);
      ASSERT_EQ(parts[i].pieces.size(), uses.size()) << text(curves);
      for (std::size_t k = 0; k < uses.size(); ++k) ASSERT_EQ(parts[i].pieces[k], uses[k].curve().value);
    }
  }
}

TEST(SweepQueries, LonePoints) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  family.add_segment(list, Point2{0, 0}, Point2{4, 4});
  family.add_point(list, {0, 0});
  EXPECT_FALSE(crosses_anything(family, list, Context()));
  family.add_point(list, {1, 1});
  family.add_point(list, {3, 1});
  EXPECT_TRUE(crosses_anything(family, list, Context()));
  const auto reported = report_intersections(family, list, Context());
  ASSERT_EQ(reported.size(), 2U);
  EXPECT_EQ(reported[1].pieces, std::vector<std::uint32_t>{0});
  EXPECT_EQ(reported[1].lone_points, std::vector<std::uint32_t>{1});
}

}  // namespace
}  // namespace quoin
