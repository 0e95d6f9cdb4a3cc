// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/set_drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "quoin/arrangement/sets/test_sets.h"
#include "quoin/base/error.h"
#include "quoin/io/drawing_curves.h"

namespace quoin {
namespace {

struct ReadBack {
  LinearPolygonSet set;
  std::optional<RingProblem> problem;
};

ReadBack read_back(const Drawing& drawing) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  RegionCurves curves;
  add_regions(family, list, drawing, curves);
  const LinearArrangement drawn = arrange(std::move(family), list, Context());
  const std::size_t elements = drawing.elements.size();
  const RegionGroups groups{curves.elements, curves.rules, std::vector<std::uint32_t>(elements, 0), 1};
  return {combine_regions(drawn, groups, SetOperation::unite),
          find_ring_problem(drawn, curves.elements, curves.is_hole)};
}

/// Every point of the symmetric difference is as close to the boundary as a vertex has moved: its area is bounded by a
/// strip along the edges of both, and a box around their vertices.
Rational area_that_may_change(const LinearPolygonSet& a, const LinearPolygonSet& b, double moved) {
  Rational bound;
  const Rational d(moved);
  for (const LinearPolygonSet* set : {&a, &b}) {
    const LinearArrangement& arrangement = set->arrangement();
    for (std::size_t e = 0; e < arrangement.edge_count(); ++e) {
      const auto end = [&](dcel::VertexId v) { return arrangement.family().exact(arrangement.point(v)); };
      const RationalPoint2 p = end(arrangement.left(dcel::EdgeId(e)));
      const RationalPoint2 q = end(arrangement.right(dcel::EdgeId(e)));
      bound += (abs(q.x - p.x) + abs(q.y - p.y) + Rational(4) * d) * Rational(2) * d;
    }
  }
  return bound;
}

TEST(SetDrawing, RoundedSetsAreValidAndClose) {
  std::mt19937 random(17);
  int rounded = 0;
  int mended = 0;
  for (int round = 0; round < 400; ++round) {
    // Near 2^52 the doubles are the integers: crossings move by up to half a unit, and boundaries fall on one another.
    const bool is_coarse = round % 2 == 0;
    const LinearPolygonSet set =
        testing::set_of(testing::random_rings(random, 1 + round % 6, 1, is_coarse ? 12 : 9, is_coarse ? 0x1p52 : 0));
    const SetDrawing drawn = draw_set(set, Context());
    const ReadBack back = read_back(drawn.drawing);
    ASSERT_FALSE(back.problem.has_value()) << round;
    const std::vector<const LinearPolygonSet*> both{&set, &back.set};
    const auto changed =
        combine<LinearFamily>(both, SetOperation::symmetric_difference, Regularity::regularized, Context());
    ASSERT_LE(area(changed), area_that_may_change(set, back.set, drawn.max_displacement)) << round;
    if (drawn.max_displacement == 0) {
      ASSERT_TRUE(changed.is_empty()) << round;
    }
    rounded += drawn.max_displacement > 0 ? 1 : 0;
    mended += drawn.rounds > 0 ? 1 : 0;
  }
  EXPECT_GT(rounded, 100);
  EXPECT_GT(mended, 10);
}

/// A piece turns through half a circle at most, so its bulge is at most its chord over the diameter, however close the
/// ends lie.
TEST(SetDrawing, ShortArcsKeepTheirSense) {
  int short_arcs = 0;
  for (int i = 1; i < 400; ++i) {
    const double low = i / 400.0;
    double high = low;
    for (int step = 0; step <= i % 3; ++step) high = std::nextafter(high, 2.0);
    CircularFamily family;
    PieceList<CircularFamily> list;
    family.add_circle(list, Point2{0, 0}, 1);
    std::vector<std::uint32_t> operands(list.curve_count, 0);
    const std::vector<Point2> strip{{-2, low}, {2, low}, {2, high}, {-2, high}};
    for (std::size_t k = 0; k < 4; ++k) family.add_segment(list, strip[k], strip[(k + 1) % 4]);
    operands.resize(list.curve_count, 1);
    const CircularPolygonSet cut =
        combine_rings(std::move(family), list, operands, 2, FillRule::nonzero, SetOperation::intersect, Context());
    ASSERT_EQ(cut.arrangement().counts().edges, 4U);
    for (const DrawingElement& element : draw_set(cut, Context()).drawing.elements) {
      for (const DrawingPath& ring : std::get<DrawingPolygon>(element.shape).rings) {
        for (std::size_t e = 0; e < ring.edge_count(); ++e) {
          const double chord = std::hypot(ring.end(e).x - ring.start(e).x, ring.end(e).y - ring.start(e).y);
          ASSERT_LE(std::fabs(ring.bulge(e)), chord) << "height " << low;
          short_arcs += ring.bulge(e) != 0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(short_arcs, 400);
}

TEST(SetDrawing, UnboundedSetsAreRefused) {
  EXPECT_THROW(draw_set(LinearPolygonSet().complement(), Context()), InputError);
}

}  // namespace
}  // namespace quoin
