// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/planar_minkowski.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "quoin/base/error.h"

namespace quoin {
namespace {

using Ring = std::vector<Point2>;
using Rings = std::vector<Ring>;

LinearPolygonSet set_of(const Rings& rings, FillRule rule = FillRule::even_odd) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  for (const Ring& ring : rings) family.add_polyline(list, ring, true);
  return combine_rings(std::move(family), list, std::vector<std::uint32_t>(rings.size(), 0), 1, rule,
                       SetOperation::unite, Context());
}

Ring box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

PlanarMinkowskiSum add(const LinearPolygonSet& a, const LinearPolygonSet& b) {
  return minkowski_sum(a, b, {.find_tight_passages = true}, Context());
}

bool are_equal(const LinearPolygonSet& a, const LinearPolygonSet& b) {
  const std::vector<const LinearPolygonSet*> pair{&a, &b};
  return combine<LinearFamily>(pair, SetOperation::symmetric_difference, Regularity::plain, Context()).is_empty();
}

LinearPolygonSet both(const LinearPolygonSet& a, const LinearPolygonSet& b, SetOperation operation,
                      Regularity regularity = Regularity::plain) {
  const std::vector<const LinearPolygonSet*> pair{&a, &b};
  return combine<LinearFamily>(pair, operation, regularity, Context());
}

std::string written(const Rings& rings) {
  std::ostringstream text;
  for (const Ring& ring : rings) {
    for (const Point2& p : ring) text << '(' << p.x << ' ' << p.y << ") ";
    text << "; ";
  }
  return text.str();
}

/// Rings on a grid that may touch and cross themselves; the even-odd rule makes sets with holes and parts of them.
Rings random_rings(std::mt19937& random, int rings, int corners, int size) {
  Rings result(static_cast<std::size_t>(rings));
  for (Ring& ring : result) {
    const std::size_t count = 3 + random() % static_cast<unsigned>(corners);
    while (ring.size() < count) {
      const Point2 p{static_cast<double>(random() % static_cast<unsigned>(size)),
                     static_cast<double>(random() % static_cast<unsigned>(size))};
      if (ring.empty() || (p != ring.back() && p != ring.front())) ring.push_back(p);
    }
  }
  return result;
}

/// Squares of a grid, each there or not: tight everywhere.
Rings random_squares(std::mt19937& random, int size) {
  Rings result;
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) {
      if (random() % 3 != 0) result.push_back(box(x, y, 1, 1));
    }
  }
  if (result.empty()) result.push_back(box(0, 0, 1, 1));
  return result;
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

struct Slow {
  LinearPolygonSet closed;
  LinearPolygonSet open;
};

/// The union of the sums of all pairs of convex pieces; the open one of all pairs of whole open parts would miss the
/// cuts between pieces, so pieces overlap there: every wall is covered by a thin piece too. Here: the closed one only.
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
  for (int round = 0; round < 150; ++round) {
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
