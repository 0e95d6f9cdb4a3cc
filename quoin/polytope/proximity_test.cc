// SPDX-License-Identifier: Apache-2.0
//
// Distances and widths against proofs: witnesses that lie in both, and planes that keep everything on its side; and
// against the hull of all differences.
#include "quoin/polytope/proximity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/polytope/convex_boundary.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/test_polytopes.h"
#include "quoin/polytope/test_sums.h"
#include "quoin/solid/query/interference.h"

namespace quoin {
namespace {

using namespace test_polytopes;

Points moved(Points points, double x, double y, double z) {
  for (Point3& p : points) p = {p.x + x, p.y + y, p.z + z};
  return points;
}

bool holds(const Points& points, const RationalPoint3& p) {
  const ConvexHull hull = convex_hull(points, one_thread);
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto facet = hull.facet(f);
    const RationalPoint3 origin = exact_point(points[facet[0]]);
    const RationalPoint3 normal = cross(exact_point(points[facet[1]]) - origin, exact_point(points[facet[2]]) - origin);
    if (dot(normal, p - origin).sign() == Sign::positive) return false;
  }
  return true;
}

/// The squared distance from the origin to the nearest facet plane of the hull of all differences.
Rational depth_by_hull(const Points& a, const Points& b) {
  Points differences;
  for (const Point3& p : a) {
    for (const Point3& q : b) differences.push_back({p.x - q.x, p.y - q.y, p.z - q.z});
  }
  const ConvexHull hull = convex_hull(differences, one_thread);
  Rational least(1e300);
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto facet = hull.facet(f);
    const RationalPoint3 origin = exact_point(differences[facet[0]]);
    const RationalPoint3 normal =
        cross(exact_point(differences[facet[1]]) - origin, exact_point(differences[facet[2]]) - origin);
    const Rational height = dot(normal, origin);
    least = std::min(least, height * height / dot(normal, normal));
  }
  return least;
}

Solid solid_of(const Points& points) {
  const ConvexHull hull = convex_hull(points, one_thread);
  Mesh mesh;
  mesh.vertices = points;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) mesh.add_face(hull.facet(f));
  return Solid::from_leaf(make_leaf(mesh, {}, one_thread).leaf, one_thread);
}

Proximity relation_of_solids(const Points& a, const Points& b) {
  switch (interference(solid_of(a), solid_of(b), one_thread).kind) {
    case Interference::overlapping:
      return Proximity::overlapping;
    case Interference::touching:
      return Proximity::touching;
    case Interference::apart:
      break;
  }
  return Proximity::apart;
}

PolytopeDistance check_distance(const Points& a, const Points& b) {
  const PolytopeDistance d =
      polytope_distance(Polytope::hull_of(a, one_thread), Polytope::hull_of(b, one_thread), one_thread);
  EXPECT_EQ(d.relation, relation_of_solids(a, b));
  EXPECT_TRUE(holds(a, d.witness[0]));
  EXPECT_TRUE(holds(b, d.witness[1]));
  const RationalPoint3 between = d.witness[0] - d.witness[1];
  if (d.relation == Proximity::overlapping) {
    EXPECT_EQ(d.squared_distance, Rational(0));
    EXPECT_EQ(d.squared_penetration, depth_by_hull(a, b));
    EXPECT_EQ(dot(d.separation, d.separation), d.squared_penetration);
    EXPECT_EQ(between, d.separation * Rational(-1));
    return d;
  }
  EXPECT_EQ(d.squared_penetration, Rational(0));
  EXPECT_EQ(dot(between, between), d.squared_distance);
  EXPECT_EQ(d.squared_distance.sign() == Sign::positive, d.relation == Proximity::apart);
  // Nothing of either comes nearer than the planes through the witnesses.
  for (const Point3& p : a) EXPECT_NE(dot(between, exact_point(p) - d.witness[0]).sign(), Sign::negative);
  for (const Point3& p : b) EXPECT_NE(dot(between, exact_point(p) - d.witness[1]).sign(), Sign::positive);
  return d;
}

const Points unit_cube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};

TEST(PolytopeDistance, OfBoxes) {
  EXPECT_EQ(check_distance(unit_cube, moved(unit_cube, 3, 0, 0)).squared_distance, Rational(4));
  EXPECT_EQ(check_distance(unit_cube, moved(unit_cube, 3, 3, 0)).squared_distance, Rational(8));
  EXPECT_EQ(check_distance(unit_cube, moved(unit_cube, 3, 3, -4)).squared_distance, Rational(17));
  EXPECT_EQ(check_distance(unit_cube, moved(unit_cube, 1, 0.5, 0.5)).relation, Proximity::touching);
  EXPECT_EQ(check_distance(unit_cube, moved(unit_cube, 1, 1, 0.5)).relation, Proximity::touching);
  EXPECT_EQ(check_distance(unit_cube, moved(unit_cube, 1, 1, 1)).relation, Proximity::touching);
  EXPECT_EQ(check_distance(unit_cube, unit_cube).squared_penetration, Rational(1));
  EXPECT_EQ(check_distance(unit_cube, moved(unit_cube, 0.75, 0.5, 0)).squared_penetration, Rational(0.0625));
  const double tiny = 0x1p-52;
  EXPECT_EQ(check_distance(unit_cube, moved(unit_cube, 1 + tiny, 0, 0)).squared_distance, Rational(0x1p-104));
  EXPECT_EQ(check_distance(unit_cube, moved(unit_cube, 1 - tiny / 2, 0, 0)).squared_penetration, Rational(0x1p-106));
}

TEST(PolytopeDistance, OfRandomPolytopesOnSmallGrids) {
  std::array<int, 3> seen{};
  for (std::uint64_t seed = 0; seed < test_rounds(1500U); ++seed) {
    Random random(seed);
    const Points a = on_a_small_grid(random, 4, 6);
    const Points b =
        moved(on_a_small_grid(random, 4, 6), below(random, 7) - 3, below(random, 7) - 3, below(random, 7) - 3);
    if (convex_hull(a, one_thread).dimension < 3 || convex_hull(b, one_thread).dimension < 3) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    ++seen.at(static_cast<std::size_t>(check_distance(a, b).relation));
    if (HasFailure()) return;
  }
  for (const int count : seen) EXPECT_GE(count, test_cases(50));
}

TEST(PolytopeDistance, OfPolytopesInGeneralPosition) {
  for (std::uint64_t seed = 0; seed < test_rounds(60U); ++seed) {
    Random random(seed);
    std::normal_distribution<double> normal;
    const auto draw = [&](double x) {
      Points points;
      for (int i = 0; i < 30; ++i) points.push_back({normal(random) + x, normal(random), normal(random)});
      return points;
    };
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Points a = draw(0);
    const Points b = draw(seed % 2 == 0 ? 5 : 8);
    const PolytopeDistance d =
        polytope_distance(Polytope::hull_of(a, one_thread), Polytope::hull_of(b, one_thread), one_thread);
    if (d.relation != Proximity::apart) continue;
    check_distance(a, b);
    if (HasFailure()) return;
  }
}

/// Whether the point is in the hull: with it, there is the same hull.
bool is_in_hull(const Points& points, const RationalPoint3& p) {
  std::vector<RationalPoint3> more;
  for (const Point3& q : points) more.push_back(exact_point(q));
  const ConvexHull hull = convex_hull(more, one_thread);
  more.push_back(p);
  const ConvexHull larger = convex_hull(more, one_thread);
  return larger.dimension == hull.dimension && larger.vertices == hull.vertices;
}

// Operands of every dimension, scaled by a third so that they are rationals, too. The witnesses are in the operands,
// and the plane that stands on what is between them has each on its side: so nothing is nearer.
TEST(PolytopeDistance, OfEveryTwoDimensions) {
  std::array<int, 3> seen{};
  for (std::uint64_t seed = 0; seed < test_rounds(500U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Points a =
        seed % 3 == 0 ? on_a_small_grid(random, 4, 8) : on_a_small_flat(random, static_cast<int>(seed % 4));
    Points b = seed % 5 < 2 ? on_a_small_grid(random, 4, 8) : on_a_small_flat(random, static_cast<int>(seed / 4 % 4));
    if (seed % 2 == 0) b = moved(b, below(random, 9) - 4, 1, 0);
    const Polytope p = Polytope::hull_of(a, one_thread);
    const Polytope q = Polytope::hull_of(b, one_thread);
    const PolytopeDistance d = polytope_distance(p, q, one_thread);
    ++seen.at(static_cast<std::size_t>(d.relation));
    ASSERT_TRUE(is_in_hull(a, d.witness[0]));
    ASSERT_TRUE(is_in_hull(b, d.witness[1]));
    const RationalPoint3 between = d.witness[0] - d.witness[1];
    if (d.relation == Proximity::overlapping) {
      ASSERT_EQ(d.squared_penetration, depth_by_hull(a, b));
      ASSERT_EQ(dot(between, between), d.squared_penetration);
    } else {
      ASSERT_EQ(dot(between, between), d.squared_distance);
      ASSERT_EQ(d.squared_distance.sign() == Sign::positive, d.relation == Proximity::apart);
      for (const Point3& x : a) ASSERT_NE(dot(between, exact_point(x) - d.witness[0]).sign(), Sign::negative);
      for (const Point3& x : b) ASSERT_NE(dot(between, exact_point(x) - d.witness[1]).sign(), Sign::positive);
    }
    const auto third_of = [](const Points& points) {
      std::vector<RationalPoint3> result;
      for (const Point3& x : points) result.push_back(exact_point(x) * (Rational(1) / Rational(3)));
      return Polytope::hull_of(result, one_thread);
    };
    const PolytopeDistance third = polytope_distance(third_of(a), third_of(b), one_thread);
    ASSERT_EQ(third.relation, d.relation);
    ASSERT_EQ(third.squared_distance * Rational(9), d.squared_distance);
    ASSERT_EQ(third.squared_penetration * Rational(9), d.squared_penetration);
    ASSERT_EQ(polytope_width(third_of(a), one_thread).squared_width * Rational(9),
              polytope_width(p, one_thread).squared_width);
    ASSERT_EQ(polytope_diameter(third_of(a), one_thread).squared_diameter * Rational(9),
              polytope_diameter(p, one_thread).squared_diameter);
  }
  for (const int count : seen) EXPECT_GE(count, test_cases(10));
}

TEST(PolytopeWidth, OfFlatOnesIsZeroAlongANormal) {
  for (const Points& points : {Points{{1, 2, 3}}, Points{{0, 0, 0}, {0, 0, 2}}, Points{{0, 0, 0}, {3, 0, 2}},
                               Points{{0, 0, 0}, {1, 2, 2}, {5, 1, 0}}}) {
    const PolytopeWidth w = polytope_width(Polytope::hull_of(points, one_thread), one_thread);
    EXPECT_EQ(w.squared_width, Rational(0));
    EXPECT_NE(dot(w.direction, w.direction), Rational(0));
    for (const Point3& p : points) EXPECT_EQ(dot(w.direction, exact_point(p) - exact_point(points[0])), Rational(0));
    EXPECT_EQ(w.faces[0].size(), points.size());
  }
}

TEST(PolytopeWidth, OfSolidsThatAreKnown) {
  const auto width = [](const Points& points) {
    const PolytopeWidth w = polytope_width(Polytope::hull_of(points, one_thread), one_thread);
    EXPECT_EQ(w.squared_width, depth_by_hull(points, points));
    // All points lie between the two planes, those of the faces in them.
    const Polytope p = Polytope::hull_of(points, one_thread);
    const RationalPoint3 high = exact_point(p.vertex(w.faces[0].at(0)));
    const RationalPoint3 low = exact_point(p.vertex(w.faces[1].at(0)));
    for (std::uint32_t v = 0; v < p.vertex_count(); ++v) {
      const Sign above = dot(w.direction, exact_point(p.vertex(v)) - high).sign();
      const Sign over = dot(w.direction, exact_point(p.vertex(v)) - low).sign();
      EXPECT_NE(above, Sign::positive);
      EXPECT_NE(over, Sign::negative);
      EXPECT_EQ(above == Sign::zero, std::ranges::count(w.faces[0], v) == 1);
      EXPECT_EQ(over == Sign::zero, std::ranges::count(w.faces[1], v) == 1);
    }
    return w.squared_width;
  };
  EXPECT_EQ(width(unit_cube), Rational(1));
  // Octahedron: two facets; tetrahedron in a unit_cube of two: two edges.
  EXPECT_EQ(width({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}), Rational(4) / Rational(3));
  EXPECT_EQ(width({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}), Rational(4));
  Random random(4);
  for (int i = 0; i < 40; ++i) {
    Points points;
    for (int k = 0; k < 12; ++k) {
      points.push_back({double(below(random, 20)), double(below(random, 9)), double(below(random, 9))});
    }
    if (convex_hull(points, one_thread).dimension == 3) width(points);
  }
  const Points square{{0, 0, 0}, {1, 0, 1}, {0, 1, 0}, {1, 1, 1}};
  EXPECT_EQ(polytope_width(Polytope::hull_of(square, one_thread), one_thread).squared_width, Rational(0));
}

TEST(PolytopeDiameter, AgreesWithAllPairs) {
  const auto check = [](const Points& points) {
    Rational most(0);
    for (const Point3& a : points) {
      for (const Point3& b : points) {
        const RationalPoint3 d = exact_point(a) - exact_point(b);
        most = std::max(most, dot(d, d));
      }
    }
    const Polytope p = Polytope::hull_of(points, one_thread);
    const PolytopeDiameter diameter = polytope_diameter(p, one_thread);
    EXPECT_EQ(diameter.squared_diameter, most);
    const RationalPoint3 d = exact_point(p.vertex(diameter.vertices[0])) - exact_point(p.vertex(diameter.vertices[1]));
    EXPECT_EQ(dot(d, d), most);
  };
  check(unit_cube);
  check({{0, 0, 0}, {1, 0, 1}, {0, 1, 0}, {1, 3, 1}});
  Random random(6);
  for (int i = 0; i < 60; ++i) {
    Points points;
    for (int k = 0; k < 15; ++k) {
      points.push_back({double(below(random, 9)), double(below(random, 9)), double(below(random, 9))});
    }
    if (convex_hull(points, one_thread).dimension > 1) check(points);
  }
}

}  // namespace
}  // namespace quoin
