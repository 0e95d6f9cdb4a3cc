// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sets/polygon_set.h"

#include <gtest/gtest.h>

#include <random>

#include "quoin/arrangement/sets/test_sets.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using testing::random_rings;
using testing::Ring;
using testing::Rings;
using testing::set_of;

int winding(const Rings& rings, const RationalPoint2& p) {
  int result = 0;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2& a = ring[i];
      const Point2& b = ring[(i + 1) % ring.size()];
      if ((Rational(a.y) > p.y) == (Rational(b.y) > p.y)) continue;
      const Rational side = (Rational(b.x) - Rational(a.x)) * (p.y - Rational(a.y)) -
                            (Rational(b.y) - Rational(a.y)) * (p.x - Rational(a.x));
      const bool upwards = a.y < b.y;
      if (upwards && side.sign() == Sign::negative) --result;  // the edge lies to the left of p
      if (!upwards && side.sign() == Sign::positive) ++result;
    }
  }
  return result;
}

/// Membership of a point that lies on no edge, from the rings that a set gives out.
bool contains(const LinearPolygonSet& set, const RationalPoint2& p) {
  const LinearArrangement& arrangement = set.arrangement();
  int crossings = 0;
  for (const PolygonWithHoles& polygon : polygons_of(set)) {
    std::vector<PolygonRing> rings = polygon.holes;
    rings.push_back(polygon.outer);
    for (const PolygonRing& ring : rings) {
      for (const dcel::HalfedgeId h : ring.halfedges) {
        const RationalPoint2 a = arrangement.family().exact(arrangement.point(arrangement.cells().origin(h)));
        const RationalPoint2 b = arrangement.family().exact(arrangement.point(arrangement.cells().target(h)));
        if ((a.y > p.y) == (b.y > p.y)) continue;
        const Rational side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
        if ((a.y < b.y) == (side.sign() == Sign::negative)) ++crossings;
      }
    }
  }
  return crossings % 2 == 1;
}

bool decide(SetOperation operation, bool a, bool b) {
  switch (operation) {
    case SetOperation::unite:
      return a || b;
    case SetOperation::intersect:
      return a && b;
    case SetOperation::subtract:
      return a && !b;
    case SetOperation::symmetric_difference:
      return a != b;
    case SetOperation::first:
      return a;
  }
  return false;
}

bool inside(int w, FillRule rule) {
  return rule == FillRule::nonzero ? w != 0 : rule == FillRule::even_odd ? w % 2 != 0 : w > 0;
}

TEST(PolygonSet, OperationsAgreeWithSamplePoints) {
  std::mt19937 random(11);
  for (int round = 0; round < test_rounds(400); ++round) {
    const int size = 3 + round % 6;
    const Rings a = random_rings(random, 1 + round % 3, 4, size);
    const Rings b = random_rings(random, 1 + round % 2, 4, size);
    const auto rule = static_cast<FillRule>(round % 3);
    const LinearPolygonSet set_a = set_of(a, rule);
    const LinearPolygonSet set_b = set_of(b, rule);
    dcel::check_links(set_a.arrangement().cells());
    ASSERT_TRUE(set_a.is_regular());
    std::vector<Rational> areas;
    for (const SetOperation operation :
         {SetOperation::unite, SetOperation::intersect, SetOperation::subtract, SetOperation::symmetric_difference}) {
      const std::vector<const LinearPolygonSet*> operands{&set_a, &set_b};
      const LinearPolygonSet result = combine<LinearFamily>(operands, operation, Regularity::regularized, Context());
      dcel::check_links(result.arrangement().cells());
      areas.push_back(area(result));
      for (int sample = 0; sample < 20; ++sample) {
        // No line through grid points this close together passes through such a point.
        const auto pick = [&](int prime) {
          const int numerator = static_cast<int>(random() % 900);
          return Rational(Integer(numerator % prime == 0 ? numerator + 1 : numerator), Integer(prime));
        };
        const Rational x = pick(101);
        const RationalPoint2 p{x, pick(103)};
        ASSERT_EQ(contains(result, p), decide(operation, inside(winding(a, p), rule), inside(winding(b, p), rule)))
            << "round " << round << " operation " << static_cast<int>(operation) << ' ' << p.x.to_string() << ' '
            << p.y.to_string();
      }
    }
    ASSERT_EQ(areas[0] + areas[1], area(set_a) + area(set_b));
    ASSERT_EQ(areas[2], area(set_a) - areas[1]);
    ASSERT_EQ(areas[3], areas[0] - areas[1]);
  }
}

TEST(PolygonSet, ManyAtOnceEqualOneByOne) {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    const std::size_t count = 2 + round % 9;
    LinearFamily family;
    PieceList<LinearFamily> list;
    std::vector<std::uint32_t> operand;
    std::vector<LinearPolygonSet> sets;
    for (std::size_t i = 0; i < count; ++i) {
      const Rings rings = random_rings(random, 1, 4, 9);
      family.add_polyline(list, rings[0], true);
      operand.push_back(static_cast<std::uint32_t>(i));
      sets.push_back(set_of(rings, FillRule::nonzero));
    }
    for (const SetOperation operation :
         {SetOperation::unite, SetOperation::intersect, SetOperation::subtract, SetOperation::symmetric_difference}) {
      const LinearPolygonSet at_once = combine_rings(family, list, operand, static_cast<std::uint32_t>(count),
                                                     FillRule::nonzero, operation, Context());
      LinearPolygonSet one_by_one = sets[0];
      for (std::size_t i = 1; i < count; ++i) {
        const std::vector<const LinearPolygonSet*> pair{&one_by_one, &sets[i]};
        one_by_one = combine<LinearFamily>(pair, operation, Regularity::regularized, Context());
      }
      EXPECT_EQ(area(at_once), area(one_by_one));
      EXPECT_EQ(at_once.arrangement().vertex_count(), one_by_one.arrangement().vertex_count());
      EXPECT_EQ(at_once.arrangement().edge_count(), one_by_one.arrangement().edge_count());
    }
  }
}

TEST(PolygonSet, PlainOperationsKeepPointsAndEdges) {
  // A peg of the width of the hole: without regularization, what is left of the closed hole less the open peg.
  const LinearPolygonSet hole = set_of({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, FillRule::nonzero);
  const LinearPolygonSet peg = set_of({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, FillRule::nonzero).interior();
  const std::vector<const LinearPolygonSet*> pair{&hole, &peg};
  const LinearPolygonSet rim = combine<LinearFamily>(pair, SetOperation::subtract, Regularity::plain, Context());
  EXPECT_EQ(rim.arrangement().counts().edges, 4U);
  EXPECT_EQ(rim.arrangement().counts().faces, 2U);
  EXPECT_FALSE(rim.is_empty());
  EXPECT_TRUE(rim.regularized().is_empty());
  const LinearPolygonSet left = set_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, FillRule::nonzero);
  const LinearPolygonSet corner = set_of({{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}, FillRule::nonzero);
  const std::vector<const LinearPolygonSet*> touching{&left, &corner};
  const LinearPolygonSet point = combine<LinearFamily>(touching, SetOperation::intersect, Regularity::plain, Context());
  EXPECT_EQ(point.arrangement().counts().isolated_vertices, 1U);
  EXPECT_EQ(point.arrangement().counts().edges, 0U);
  EXPECT_TRUE(combine<LinearFamily>(touching, SetOperation::intersect, Regularity::regularized, Context()).is_empty());
}

TEST(PolygonSet, TopologicalOperators) {
  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    const LinearPolygonSet set = set_of(random_rings(random, 2, 4, 5), FillRule::even_odd);
    EXPECT_EQ(area(set.complement().complement()), area(set));
    EXPECT_TRUE(set.interior().closure().is_regular());
    EXPECT_EQ(area(set.interior().closure()), area(set));
    const std::vector<const LinearPolygonSet*> itself{&set, &set};
    EXPECT_TRUE(
        combine<LinearFamily>(itself, SetOperation::symmetric_difference, Regularity::plain, Context()).is_empty());
    const LinearPolygonSet outside = set.complement();
    const std::vector<const LinearPolygonSet*> both{&set, &outside};
    EXPECT_TRUE(combine<LinearFamily>(both, SetOperation::unite, Regularity::plain, Context()).is_everything());
    EXPECT_TRUE(combine<LinearFamily>(both, SetOperation::intersect, Regularity::plain, Context()).is_empty());
    if (!set.is_empty()) {
      EXPECT_EQ(set.boundary().arrangement().counts().edges, set.arrangement().counts().edges);
    }
  }
}

}  // namespace
}  // namespace quoin
