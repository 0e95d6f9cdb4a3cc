// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sets/planar_minkowski.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>

#include "quoin/arrangement/sets/test_sets.h"
#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using testing::are_equal;
using testing::both;
using testing::box;
using testing::random_rings;
using testing::random_squares;
using testing::Ring;
using testing::Rings;
using testing::set_of;
using testing::written;

PlanarMinkowskiSum add(const LinearPolygonSet& a, const LinearPolygonSet& b) {
  return minkowski_sum(a, b, {.find_tight_passages = true}, Context());
}

using Exact = std::vector<RationalPoint2>;

Rational cross(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Counterclockwise hull without straight vertices, by Andrew's scan.
Exact hull_of(Exact points) {
  const auto less = [](const RationalPoint2& a, const RationalPoint2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Exact hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const RationalPoint2& p : points) {
      while (hull.size() >= begin + 2 && cross(hull[hull.size() - 2], hull.back(), p).sign() != Sign::positive) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

void add_ring(LinearFamily& family, PieceList<LinearFamily>& list, const Exact& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) family.add_segment(list, ring[i], ring[(i + 1) % ring.size()]);
}

/// Trapezoids between the verticals through all vertices, which have convex pieces whatever the set is.
std::vector<Exact> trapezoids(const LinearPolygonSet& set) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  const LinearArrangement& from = set.arrangement();
  for (std::size_t v = 0; v < from.vertex_count(); ++v) {
    if (!from.cells().is_real(dcel::VertexId(v))) continue;
    const RationalPoint2 p = from.family().exact(from.point(dcel::VertexId(v)));
    family.add_segment(list, RationalPoint2{p.x, Rational(-1000)}, RationalPoint2{p.x, Rational(1000)});
  }
  const LinearArrangement walls = arrange(std::move(family), list, Context());
  const LinearPolygonSet cuts(walls, std::vector<bool>(walls.vertex_count(), false),
                              std::vector<bool>(walls.edge_count(), true),
                              std::vector<bool>(walls.face_count(), false));
  const LinearPolygonSet cut = both(set, cuts, SetOperation::subtract);
  std::vector<Exact> result;
  for (const PolygonWithHoles& polygon : polygons_of(cut)) {
    Exact points;
    for (const dcel::HalfedgeId h : polygon.outer.halfedges) {
      points.push_back(cut.arrangement().family().exact(cut.arrangement().point(cut.arrangement().cells().origin(h))));
    }
    result.push_back(hull_of(points));
  }
  return result;
}

/// The union of the sums of all pairs of convex pieces.
LinearPolygonSet slow_sum(const LinearPolygonSet& a, const LinearPolygonSet& b) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  const std::vector<Exact> pieces_a = trapezoids(a);
  const std::vector<Exact> pieces_b = trapezoids(b);
  for (const Exact& p : pieces_a) {
    for (const Exact& q : pieces_b) {
      Exact sums;
      for (const RationalPoint2& s : p) {
        for (const RationalPoint2& t : q) sums.push_back({s.x + t.x, s.y + t.y});
      }
      add_ring(family, list, hull_of(sums));
    }
  }
  return combine_rings(std::move(family), list, std::vector<std::uint32_t>(list.curve_count, 0), 1, FillRule::nonzero,
                       SetOperation::unite, Context());
}

TEST(PlanarMinkowski, AgreesWithSumsOfConvexPieces) {
  std::mt19937 random(7);
  for (int round = 0; round < test_rounds(150); ++round) {
    const int size = 3 + round % 5;
    const bool squares = round % 3 == 0;
    const Rings a = squares ? random_squares(random, 4) : random_rings(random, 1 + round % 2, 5, size);
    const Rings b = squares ? random_squares(random, 2) : random_rings(random, 1, 3 + round % 3, 2 + size / 2);
    const LinearPolygonSet set_a = set_of(a);
    const LinearPolygonSet set_b = set_of(b);
    SCOPED_TRACE("round " + std::to_string(round) + ": " + written(a) + " and " + written(b));
    const PlanarMinkowskiSum result = minkowski_sum(set_a, set_b, {}, Context());
    dcel::check_links(result.sum.arrangement().cells());
    ASSERT_TRUE(result.sum.is_regular());
    ASSERT_TRUE(are_equal(result.sum, slow_sum(set_a, set_b)));
  }
}

/// A set of nothing but points.
LinearPolygonSet points_set(const std::vector<Point2>& points) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  for (const Point2& p : points) family.add_point(list, p);
  const LinearArrangement drawn = arrange(std::move(family), list, Context());
  return {drawn, std::vector<bool>(drawn.vertex_count(), true), std::vector<bool>(drawn.edge_count(), false),
          std::vector<bool>(drawn.face_count(), false)};
}

/// On all points with coordinates that are multiples of a half, whether the open sets meet.
void expect_open_sum(const LinearPolygonSet& a, const LinearPolygonSet& b, const PlanarMinkowskiSum& result, int size) {
  std::vector<Point2> all;
  std::vector<Point2> members;
  for (int x = -1; x <= 2 * size; ++x) {
    for (int y = -1; y <= 2 * size; ++y) {
      const Point2 p{x / 2.0, y / 2.0};
      all.push_back(p);
      const LinearPolygonSet moved = reflected(b, {p.x, p.y}, Context());
      if (!both(a, moved, SetOperation::intersect, Regularity::regularized).is_empty()) members.push_back(p);
    }
  }
  EXPECT_TRUE(are_equal(both(result.open_sum, points_set(all), SetOperation::intersect), points_set(members)));
  EXPECT_TRUE(are_equal(both(result.open_sum, result.tight, SetOperation::unite), result.sum.interior()));
  EXPECT_TRUE(both(result.open_sum, result.tight, SetOperation::intersect).is_empty());
}

TEST(PlanarMinkowski, OpenSumHoldsWhereOpenSetsMeet) {
  std::mt19937 random(19);
  std::size_t slits = 0;
  std::size_t isolated = 0;
  for (int round = 0; round < test_rounds(60); ++round) {
    const bool squares = round % 4 != 0;
    const Rings a = squares ? random_squares(random, 3 + round % 3) : random_rings(random, 1, 4, 5);
    const Rings b = squares ? random_squares(random, 1 + round % 2) : random_rings(random, 1, 2, 3);
    const LinearPolygonSet set_a = set_of(a);
    const LinearPolygonSet set_b = set_of(b);
    SCOPED_TRACE("round " + std::to_string(round) + ": " + written(a) + " and " + written(b));
    const PlanarMinkowskiSum result = add(set_a, set_b);
    expect_open_sum(set_a, set_b, result, 8);
    slits += result.slits;
    isolated += result.isolated_points;
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_GE(slits, test_cases(50U));
  EXPECT_GE(isolated, test_cases(5U));
}

TEST(PlanarMinkowski, AreaOfConvexSums) {
  // area(P + Q) = area(P) + area(Q) + 2 V(P, Q); twice the mixed area by the support function of P at Q's normals.
  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    std::array<Exact, 2> hulls;
    for (Exact& hull : hulls) {
      while (hull.size() < 3) {
        Exact points;
        for (int i = 0; i < 3 + round % 9; ++i) {
          points.push_back({Rational(static_cast<int>(random() % 9)), Rational(static_cast<int>(random() % 9))});
        }
        hull = hull_of(points);
      }
    }
    if (round % 10 == 0) {  // homothetic
      hulls[1] = hulls[0];
      for (RationalPoint2& p : hulls[1]) p = {p.x * Rational(2), p.y * Rational(2)};
    }
    Rational mixed;
    for (std::size_t i = 0; i < hulls[1].size(); ++i) {
      const RationalPoint2& a = hulls[1][i];
      const RationalPoint2& b = hulls[1][(i + 1) % hulls[1].size()];
      const auto height = [&](const RationalPoint2& p) { return (b.y - a.y) * p.x - (b.x - a.x) * p.y; };
      Rational support = height(hulls[0][0]);
      for (const RationalPoint2& p : hulls[0]) support = std::max(support, height(p));
      mixed += support;
    }
    std::array<LinearPolygonSet, 2> sets;
    for (int i = 0; i < 2; ++i) {
      LinearFamily family;
      PieceList<LinearFamily> list;
      add_ring(family, list, hulls[i]);
      sets[i] = combine_rings(std::move(family), list, std::vector<std::uint32_t>(list.curve_count, 0), 1,
                              FillRule::positive, SetOperation::unite, Context());
    }
    const PlanarMinkowskiSum result = add(sets[0], sets[1]);
    EXPECT_EQ(area(result.sum), area(sets[0]) + area(sets[1]) + mixed) << "round " << round;
    EXPECT_TRUE(result.tight.is_empty());
    EXPECT_LE(result.sum.arrangement().counts().edges, hulls[0].size() + hulls[1].size());
    EXPECT_TRUE(round % 10 != 0 || result.sum.arrangement().counts().edges == hulls[0].size());
  }
}

TEST(PlanarMinkowski, CommutesAndMovesWithItsOperands) {
  std::mt19937 random(23);
  const RationalPoint2 vector{Rational(Integer(1), Integer(3)), Rational(0.1)};
  for (int round = 0; round < test_rounds(40); ++round) {
    const Rings a = random_rings(random, 2, 4, 6);
    const Rings b = random_rings(random, 1, 3, 4);
    const LinearPolygonSet set_a = set_of(a);
    const LinearPolygonSet set_b = set_of(b);
    SCOPED_TRACE("round " + std::to_string(round) + ": " + written(a) + " and " + written(b));
    const PlanarMinkowskiSum result = add(set_a, set_b);
    const PlanarMinkowskiSum swapped = add(set_b, set_a);
    EXPECT_TRUE(are_equal(result.sum, swapped.sum));
    EXPECT_TRUE(are_equal(result.open_sum, swapped.open_sum));
    const PlanarMinkowskiSum moved = add(translated(set_a, vector, Context()), set_b);
    EXPECT_TRUE(are_equal(moved.sum, translated(result.sum, vector, Context())));
    EXPECT_TRUE(are_equal(moved.open_sum, translated(result.open_sum, vector, Context())));
    const PlanarMinkowskiSum mirrored = add(reflected(set_a, Context()), reflected(set_b, Context()));
    EXPECT_TRUE(are_equal(mirrored.tight, reflected(result.tight, Context())));
    EXPECT_TRUE(are_equal(mirrored.sum, reflected(result.sum, Context())));
    EXPECT_EQ(mirrored.holes, result.holes);
  }
}

TEST(PlanarMinkowski, DoublesOfAllSizesAddExactly) {
  const LinearPolygonSet tiny = set_of({box(-0x1p-60, -0x1p-60, 0x1p-59, 0x1p-59)});
  const LinearPolygonSet big = set_of({{{0, 0}, {3, 0}, {3, 3}, {1, 1}, {0, 3}}, box(0.1, 0.1, 0.2, 0.3)});
  const PlanarMinkowskiSum result = add(big, tiny);
  EXPECT_TRUE(both(big, result.sum, SetOperation::subtract).is_empty());
  EXPECT_GT(area(result.sum), area(big));
  EXPECT_EQ(result.holes, 1U);
  EXPECT_TRUE(are_equal(result.sum, slow_sum(big, tiny)));
  const LinearPolygonSet far = set_of({box(0x1.8p1023, 0, 0x1p1000, 0x1p1000)});
  EXPECT_EQ(area(add(far, far).sum), Rational(4) * area(far));
}

TEST(PlanarMinkowski, SlitOfTheBodysWidth) {
  // A corridor of width 2 into a room: a box of that width passes, one that is a little wider does not.
  const LinearPolygonSet walls = set_of({{{0, 0}, {20, 0}, {20, 12}, {0, 12}}, box(2, 2, 8, 8), box(10, 5, 8, 2)});
  EXPECT_EQ(area(walls), Rational(240 - 64 - 16));
  const PlanarMinkowskiSum result = add(walls, set_of({box(-2, -2, 2, 2)}));
  EXPECT_EQ(result.slits, 1U);
  EXPECT_EQ(result.isolated_points, 0U);
  EXPECT_EQ(result.holes, 1U);
  const LinearPolygonSet& tight = result.tight;
  ASSERT_EQ(tight.arrangement().counts().edges, 1U);
  const LinearArrangement& cells = tight.arrangement();
  EXPECT_EQ(cells.point(cells.left(dcel::EdgeId(std::size_t{0}))).x, 8);
  EXPECT_EQ(cells.point(cells.right(dcel::EdgeId(std::size_t{0}))).x, 16);
  EXPECT_EQ(cells.point(cells.left(dcel::EdgeId(std::size_t{0}))).y, 5);
  EXPECT_EQ(add(walls, set_of({box(-2, -2, 2, 2.5)})).slits, 0U);
  EXPECT_EQ(add(walls, set_of({box(-2, -2, 2, 1.5)})).slits, 0U);
}

TEST(PlanarMinkowski, PegOfTheHolesSizeLeavesAPoint) {
  const LinearPolygonSet plate = set_of({box(0, 0, 10, 10), box(3, 4, 2, 3)});
  const PlanarMinkowskiSum result = add(plate, set_of({box(-2, -3, 2, 3)}));
  EXPECT_EQ(result.isolated_points, 1U);
  EXPECT_EQ(result.slits, 0U);
  EXPECT_EQ(result.vanished_holes, 1U);
  ASSERT_EQ(result.tight.arrangement().vertex_count(), 1U);
  EXPECT_EQ(result.tight.arrangement().point(dcel::VertexId(std::size_t{0})).x, 3);
  EXPECT_EQ(result.tight.arrangement().point(dcel::VertexId(std::size_t{0})).y, 4);
  EXPECT_FALSE(result.open_sum.is_empty());
  // A hexagon with slanted sides, rationals and no axis of symmetry.
  const Ring peg{{0, 0}, {0.3, -0.1}, {0.9, 0.2}, {0.7, 0.8}, {0.4, 0.9}, {-0.1, 0.5}};
  const LinearPolygonSet shaped = set_of({box(-3, -3, 6, 6), peg});
  const PlanarMinkowskiSum fitted = add(shaped, reflected(set_of({peg}), Context()));
  EXPECT_EQ(fitted.isolated_points, 1U);
  EXPECT_EQ(fitted.holes, 0U);
}

TEST(PlanarMinkowski, NearlyDegenerateDoubles) {
  // Grids in tenths: what would be parallel, collinear or equal there is off by a unit in the last place.
  std::mt19937 random(41);
  for (int round = 0; round < test_rounds(40); ++round) {
    Rings a = round % 2 == 0 ? random_squares(random, 3) : random_rings(random, 2, 4, 5);
    Rings b = random_rings(random, 1, 3, 4);
    for (Rings* rings : {&a, &b}) {
      for (Ring& ring : *rings) {
        for (Point2& p : ring) p = {p.x * 0.1, p.y * 0.1 + (round % 4 == 3 ? 1.0 : 0.0)};
      }
    }
    const LinearPolygonSet set_a = set_of(a);
    const LinearPolygonSet set_b = set_of(b);
    SCOPED_TRACE("round " + std::to_string(round) + ": " + written(a) + " and " + written(b));
    const PlanarMinkowskiSum result = add(set_a, set_b);
    ASSERT_TRUE(are_equal(result.sum, slow_sum(set_a, set_b)));
    EXPECT_TRUE(are_equal(both(result.open_sum, result.tight, SetOperation::unite), result.sum.interior()));
    EXPECT_TRUE(both(result.open_sum, result.tight, SetOperation::intersect).is_empty());
  }
}

TEST(PlanarMinkowski, PegsThatAreOneUnitOff) {
  const LinearPolygonSet plate = set_of({box(0, 0, 10, 10), box(3, 4, 2, 3)});
  const double over = std::nextafter(2.0, 3.0);
  const double under = std::nextafter(2.0, 1.0);
  const PlanarMinkowskiSum wide = add(plate, set_of({box(-1, -1, over, 3)}));
  EXPECT_EQ(wide.holes, 0U);
  EXPECT_TRUE(wide.tight.is_empty());
  const PlanarMinkowskiSum narrow = add(plate, set_of({box(-1, -1, under, 3)}));
  EXPECT_EQ(narrow.slits, 1U);
  EXPECT_EQ(narrow.isolated_points, 0U);
  const PlanarMinkowskiSum loose = add(plate, set_of({box(-1, -1, under, std::nextafter(3.0, 0.0))}));
  EXPECT_EQ(loose.holes, 1U);
  EXPECT_TRUE(loose.tight.is_empty());
  EXPECT_TRUE(are_equal(loose.sum, slow_sum(plate, set_of({box(-1, -1, under, std::nextafter(3.0, 0.0))}))));
}

TEST(PlanarMinkowski, CombsThatInterlock) {
  // Teeth of width 1 at a distance of 1: the teeth go into the gaps exactly; thinner teeth leave boxes.
  const auto comb = [](int teeth, double width) {
    Rings rings{box(0, 0, 2 * teeth, 1)};
    for (int i = 0; i < teeth; ++i) rings.push_back(box(2 * i, 1, width, 4));
    return set_of(rings);
  };
  const LinearPolygonSet lower = comb(5, 1);
  const PlanarMinkowskiSum exact = add(lower, lower);
  EXPECT_TRUE(are_equal(exact.sum, slow_sum(lower, lower)));
  EXPECT_GT(exact.slits, 0U);
  const LinearPolygonSet thin = comb(5, 0.5);
  const PlanarMinkowskiSum loose = add(lower, thin);
  EXPECT_TRUE(are_equal(loose.sum, slow_sum(lower, thin)));
}

TEST(PlanarMinkowski, NewHolesOfOpenRings) {
  // A room with a door that a box is too wide for: outside becomes a hole.
  const LinearPolygonSet room =
      set_of({{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 6}, {1, 6}, {1, 9}, {9, 9}, {9, 1}, {1, 1}, {1, 4}, {0, 4}}});
  const PlanarMinkowskiSum closed = add(room, set_of({box(0, 0, 3, 3)}));
  EXPECT_EQ(closed.holes, 1U);
  EXPECT_EQ(closed.new_holes, 1U);
  const PlanarMinkowskiSum passing = add(room, set_of({box(0, 0, 2, 2)}));
  EXPECT_EQ(passing.holes, 1U);
  EXPECT_EQ(passing.slits, 1U);
  EXPECT_EQ(add(room, set_of({box(0, 0, 1, 1)})).holes, 0U);
}

TEST(PlanarMinkowski, EmptyAndUnboundedOperands) {
  const LinearPolygonSet square = set_of({box(0, 0, 1, 1)});
  EXPECT_TRUE(add(square, LinearPolygonSet()).sum.is_empty());
  EXPECT_TRUE(add(LinearPolygonSet(), LinearPolygonSet()).open_sum.is_empty());
  EXPECT_THROW(add(square.complement(), square), InputError);
  EXPECT_TRUE(reflected(LinearPolygonSet().complement(), Context()).is_everything());
  const LinearPolygonSet outside = square.complement();
  EXPECT_TRUE(are_equal(reflected(outside, {Rational(1), Rational(1)}, Context()), outside));
}

TEST(PlanarMinkowski, HolesThatTheOtherCannotEnterAreNoTrap) {
  // About the middle, the intersection is a ring.
  const LinearPolygonSet frame = set_of({box(0, 0, 10, 10), box(4, 4, 2, 2)});
  const PlanarMinkowskiSum result = add(frame, set_of({box(0, 0, 4, 4)}));
  EXPECT_TRUE(are_equal(result.sum, set_of({box(0, 0, 14, 14)})));
  EXPECT_EQ(result.holes, 0U);
  EXPECT_EQ(result.vanished_holes, 1U);
  const PlanarMinkowskiSum wide = add(frame, set_of({box(0, 0, 1, 1)}));
  EXPECT_TRUE(are_equal(wide.sum, set_of({box(0, 0, 11, 11), box(5, 5, 1, 1)})));
  EXPECT_EQ(wide.holes, 1U);
  EXPECT_EQ(wide.new_holes, 0U);
}

}  // namespace
}  // namespace quoin
