// SPDX-License-Identifier: Apache-2.0
//
// Answers of walks against those of all facets: distances of polytopes that were moved, and the hull of all
// differences. Translations on small grids lie in planes, on edges and at vertices of the body; others close to these.
#include "quoin/polytope/proximity_queries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/test_polytopes.h"

namespace quoin {
namespace {

using namespace test_polytopes;

Polytope polytope(const Points& points) {
  return Polytope::hull_of(points, one_thread);
}
Points moved(Points points, const Vector3& t) {
  for (Point3& p : points) p = {p.x + t.x, p.y + t.y, p.z + t.z};
  return points;
}

/// The half-spaces of the hull of all differences, by which every answer can be found without a walk.
class AllFacets {
 public:
  AllFacets(const Points& first, const Points& second) {
    Points differences;
    for (const Point3& p : first) {
      for (const Point3& q : second) differences.push_back({q.x - p.x, q.y - p.y, q.z - p.z});
    }
    const ConvexHull hull = convex_hull(differences, one_thread);
    for (std::size_t f = 0; f < hull.facet_count(); ++f) {
      const auto facet = hull.facet(f);
      const RationalPoint3 origin = exact_point(differences[facet[0]]);
      normals_.push_back(
          cross(exact_point(differences[facet[1]]) - origin, exact_point(differences[facet[2]]) - origin));
      offsets_.push_back(dot(normals_.back(), origin));
    }
  }

  /// 3 where none is outside and none contains it; what is left of its dimension otherwise, -1 outside.
  int contact_dimension(const RationalPoint3& t) const {
    int planes = 0;
    for (std::size_t f = 0; f < normals_.size(); ++f) {
      const Sign sign = (dot(normals_[f], t) - offsets_[f]).sign();
      if (sign == Sign::positive) return -1;
      if (sign == Sign::zero) ++planes;
    }
    return 3 - std::min(planes, 3);
  }
  Rational depth(const RationalPoint3& t, const RationalPoint3& direction) const {
    Rational least(-1);
    for (std::size_t f = 0; f < normals_.size(); ++f) {
      const Rational speed = dot(normals_[f], direction);
      if (speed.sign() != Sign::positive) continue;
      const Rational value = (offsets_[f] - dot(normals_[f], t)) / speed;
      if (least.sign() == Sign::negative || value < least) least = value;
    }
    return least;
  }

 private:
  std::vector<RationalPoint3> normals_;
  std::vector<Rational> offsets_;
};

RationalPoint3 exact_vector(const Vector3& v) {
  return {Rational(v.x), Rational(v.y), Rational(v.z)};
}

/// Nothing of the moved points is further in the direction than a point.
void expect_supporting(const Points& points, const Vector3& by, const RationalPoint3& at,
                       const RationalPoint3& direction) {
  for (const Point3& p : points) {
    EXPECT_NE(dot(direction, exact_point(p) + exact_vector(by) - at).sign(), Sign::positive);
  }
}

/// Whether the moved hull holds the point.
bool holds(const Polytope& p, const Vector3& by, const RationalPoint3& at) {
  for (std::uint32_t f = 0; f < p.facet_count(); ++f) {
    const std::uint32_t h = p.first_halfedge(f);
    const RationalPoint3 a = exact_point(p.edge(h).from);
    const RationalPoint3 b = exact_point(p.edge(h).to);
    const RationalPoint3 c = exact_point(p.edge(p.halfedges()[h].next).to);
    if (dot(cross(b - a, c - a), at - exact_vector(by) - a).sign() == Sign::positive) return false;
  }
  return true;
}

struct Pair {
  Points a;
  Points b;
  Polytope first = polytope(a);
  Polytope second = polytope(b);
  ProximityQueries queries{first, second, one_thread};
  AllFacets facets{a, b};
};

bool are_exact(const Points& moved_points, const Points& points, const Vector3& t) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(exact_point(moved_points[i]) == exact_point(points[i]) + exact_vector(t))) return false;
  }
  return true;
}

void check_distance(const Pair& pair, const Vector3& t, int dimension, ProximityHint& hint) {
  const TranslationDistance d = pair.queries.distance(t, hint);
  const TranslationNearest nearest = pair.queries.nearest(t, hint);
  EXPECT_EQ(d.relation, dimension < 0   ? Proximity::apart
                        : dimension < 3 ? Proximity::touching
                                        : Proximity::overlapping);
  EXPECT_EQ(nearest.relation, d.relation);
  EXPECT_TRUE(nearest.squared_distance.contains(d.squared_distance));
  const Points at = moved(pair.a, t);
  if (are_exact(at, pair.a, t)) {
    const PolytopeDistance other = polytope_distance(polytope(at), pair.second, one_thread);
    EXPECT_EQ(d.relation, other.relation);
    EXPECT_EQ(d.squared_distance, other.squared_distance);
    const ShortestPenetration shortest = pair.queries.shortest_penetration(t, hint, one_thread);
    EXPECT_EQ(shortest.squared_depth, other.squared_penetration);
    EXPECT_EQ(dot(shortest.separation, shortest.separation), other.squared_penetration);
    if (d.relation == Proximity::overlapping) {
      EXPECT_EQ(pair.facets.contact_dimension(exact_vector(t) + shortest.separation), 2);
      EXPECT_TRUE(holds(pair.first, t, shortest.witness[0]));
      EXPECT_TRUE(holds(pair.second, {}, shortest.witness[1]));
    }
  }
  if (d.relation == Proximity::overlapping) return;
  const RationalPoint3 between = d.witness[1] - d.witness[0];
  EXPECT_EQ(dot(between, between), d.squared_distance);
  EXPECT_EQ(d.squared_distance.sign() == Sign::positive, d.relation == Proximity::apart);
  EXPECT_TRUE(holds(pair.first, t, d.witness[0]));
  EXPECT_TRUE(holds(pair.second, {}, d.witness[1]));
  expect_supporting(pair.a, t, d.witness[0], between);
  expect_supporting(pair.b, {}, d.witness[1], between * Rational(-1));
}

/// By all facets at what is told, and beside it.
void check_passage(const Pair& pair, const Vector3& from, const Vector3& to, ProximityHint& hint,
                   std::array<int, 3>& seen) {
  const TranslationPassage p = pair.queries.passage(from, to, hint, one_thread);
  ++seen.at(static_cast<std::size_t>(p.relation));
  const auto dimension = [&](const Rational& part) {
    return pair.facets.contact_dimension(exact_vector(from) + (exact_vector(to) - exact_vector(from)) * part);
  };
  if (p.relation == Proximity::apart) {
    for (int i = 0; i <= 8; ++i) EXPECT_EQ(dimension(Rational(i) / Rational(8)), -1);
    return;
  }
  EXPECT_LE(Rational(0), p.enter);
  EXPECT_LE(p.enter, p.leave);
  EXPECT_LE(p.leave, Rational(1));
  EXPECT_NE(dimension(p.enter), -1);
  EXPECT_NE(dimension(p.leave), -1);
  EXPECT_EQ(dimension((p.enter + p.leave) / Rational(2)) == 3, p.relation == Proximity::overlapping);
  const Rational tiny(0x1p-40);
  if (p.enter.sign() == Sign::positive) {
    EXPECT_EQ(dimension(p.enter - tiny), -1);
  }
  if (p.leave < Rational(1)) {
    EXPECT_EQ(dimension(p.leave + tiny), -1);
  }
}

void check(const Pair& pair, const Vector3& t, const Vector3& direction, ProximityHint& hint,
           std::array<int, 5>& seen) {
  SCOPED_TRACE("translation " + std::to_string(t.x) + " " + std::to_string(t.y) + " " + std::to_string(t.z));
  const int dimension = pair.facets.contact_dimension(exact_vector(t));
  ++seen.at(static_cast<std::size_t>(dimension + 1));
  check_distance(pair, t, dimension, hint);
  const TranslationRelation relation = pair.queries.relation(t, hint);
  if (dimension >= 0 && dimension < 3) {
    EXPECT_EQ(relation.feature.dimension, dimension);
  }
  const DirectionalPenetration p = pair.queries.penetration(t, direction, hint);
  if (dimension < 3) {
    EXPECT_EQ(p.depth, Rational(0));
    return;
  }
  EXPECT_EQ(p.depth, pair.facets.depth(exact_vector(t), exact_vector(direction)));
  const RationalPoint3 end = exact_vector(t) + exact_vector(direction) * p.depth;
  const int at_end = pair.facets.contact_dimension(end);
  EXPECT_TRUE(0 <= at_end && at_end < 3);
}

const Points cube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
const Points corner{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0, 0, 1}};

TEST(ProximityQueries, TheTranslationMovesTheFirst) {
  const Pair pair{corner, moved(cube, {10, 0, 0})};
  ProximityHint hint;
  // The long edge of the corner reaches 4 along x, so 6 bring it to the cube at 10; from behind, 11 do.
  EXPECT_EQ(pair.queries.distance({0, 0, 0}, hint).squared_distance, Rational(36));
  EXPECT_EQ(pair.queries.relation({6, 0, 0}, hint).relation, Proximity::touching);
  EXPECT_EQ(pair.queries.relation({6.5, 0, 0}, hint).relation, Proximity::overlapping);
  EXPECT_EQ(pair.queries.relation({11, 0, 0}, hint).relation, Proximity::touching);
  EXPECT_EQ(pair.queries.distance({12, 0, 0}, hint).squared_distance, Rational(1));
  EXPECT_EQ(pair.queries.distance({5, 0.5, 0.5}, hint).witness[0], (RationalPoint3{9, 0.5, 0.5}));
  // The body of translations reaches from 6 to 11 along x.
  EXPECT_EQ(pair.queries.penetration({7, 0.25, 0.25}, {2, 0, 0}, hint).depth, Rational(2));
  EXPECT_EQ(pair.queries.penetration({7, 0, 0}, {-1, 0, 0}, hint).depth, Rational(1));
  const auto faces = pair.queries.faces_of(pair.queries.relation({6, 0.5, 0.5}, hint).feature);
  EXPECT_EQ(faces[0].size(), 1U);
  EXPECT_EQ(pair.first.vertex(faces[0][0]), (Point3{4, 0, 0}));
  EXPECT_EQ(faces[1].size(), 4U);
}

TEST(ProximityQueries, OfCubesThatGraze) {
  const Pair pair{cube, cube};
  ProximityHint hint;
  const auto dimension = [&](double x, double y, double z) {
    const TranslationRelation relation = pair.queries.relation({x, y, z}, hint);
    return relation.relation == Proximity::touching ? relation.feature.dimension : -1;
  };
  EXPECT_EQ(dimension(1, 0.5, 0.25), 2);
  EXPECT_EQ(dimension(1, 0, 0), 2);
  EXPECT_EQ(dimension(1, 1, 0), 1);
  EXPECT_EQ(dimension(1, -1, 0.75), 1);
  EXPECT_EQ(dimension(1, -1, 1), 0);
  EXPECT_EQ(dimension(1, -1, 1 + 0x1p-52), -1);
  EXPECT_EQ(pair.queries.distance({1, -1, 1 + 0x1p-52}, hint).squared_distance, Rational(0x1p-104));
  EXPECT_EQ(pair.queries.relation({1 - 0x1p-53, 0, 0}, hint).relation, Proximity::overlapping);
  EXPECT_EQ(pair.queries.relation({0, 0, 0}, hint).relation, Proximity::overlapping);
}

TEST(ProximityQueries, AgreeWithAllFacetsOnSmallGrids) {
  std::array<int, 5> seen{};
  for (std::uint64_t seed = 0; seed < test_rounds(100U); ++seed) {
    Random random(seed);
    const Points a = on_a_small_grid(random, 4, 6);
    const Points b = on_a_small_grid(random, 4, 6);
    const std::array<int, 2> dimensions{convex_hull(a, one_thread).dimension, convex_hull(b, one_thread).dimension};
    if (std::min(dimensions[0], dimensions[1]) < 2 || std::max(dimensions[0], dimensions[1]) < 3) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Pair pair{a, b};
    ProximityHint hint;
    Vector3 t{};
    for (int round = 0; round < 12; ++round) {
      const auto draw = [&](int reach) { return 0.5 * (below(random, 4 * reach + 1) - 2 * reach); };
      t = round % 3 == 0 ? Vector3{draw(4), draw(4), draw(4)} : Vector3{t.x + draw(1), t.y + draw(1), t.z + draw(1)};
      if (round % 3 == 1) {  // a vertex of the body, or between two, of which many are on an edge
        const auto vertex = [&] {
          return pair.queries.body().exact(static_cast<std::uint32_t>(random() % pair.queries.body().vertex_count()));
        };
        const RationalPoint3 p = (vertex() + vertex()) * Rational(0.5);
        t = {p.x.to_double(), p.y.to_double(), p.z.to_double()};
      }
      Vector3 direction{draw(2), draw(2), draw(2)};
      if (direction == Vector3{}) direction = {0, 0, -3};
      if (round % 4 == 0) hint = {};
      check(pair, t, direction, hint, seen);
      if (HasFailure()) return;
    }
  }
  for (const int count : seen) EXPECT_GE(count, test_cases(10));
}

/// At vertices, on edges and in facets of the body, and the neighbours in doubles of these.
TEST(ProximityQueries, AgreeCloseToTheBoundary) {
  std::array<int, 5> seen{};
  for (std::uint64_t seed = 0; seed < test_rounds(12U); ++seed) {
    Random random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double away = seed % 3 == 0 ? 0 : 1000;
    const auto draw = [&](int count) {
      Points points;
      for (int i = 0; i < count; ++i) {
        const Vector3 p{unit(random), unit(random), unit(random)};
        // Multiples of 2^-20, so that all differences are doubles.
        points.push_back({std::round(p.x * 0x1p20) * 0x1p-20 + away, std::round(p.y * 0x1p20) * 0x1p-20,
                          std::round(p.z * 0x1p20) * 0x1p-20});
      }
      return points;
    };
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Pair pair{draw(12), moved(draw(9), {away, 0, 0})};
    const TranslationBody& body = pair.queries.body();
    ProximityHint hint;
    for (int round = 0; round < 14; ++round) {
      const auto f = static_cast<std::uint32_t>(random() % body.facet_count());
      const std::uint32_t rim = body.first_rim(f);
      const auto vertex = [&](std::uint32_t v) {
        const RationalPoint3 p = body.exact(v);
        return Vector3{p.x.to_double(), p.y.to_double(), p.z.to_double()};
      };
      const Vector3 p = vertex(body.tail(rim));
      const Vector3 q = vertex(body.head(rim));
      Vector3 t = round % 2 == 0 ? p : Vector3{(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
      if (round % 4 > 1) t.x = std::nextafter(t.x, unit(random));
      if (round % 4 == 3) t.z = std::nextafter(t.z, unit(random));
      check(pair, t, {unit(random), unit(random), unit(random)}, hint, seen);
      if (HasFailure()) return;
    }
  }
  for (std::size_t i : {0U, 1U, 2U, 4U}) EXPECT_GE(seen.at(i), test_cases(10));
}

TEST(ProximityQueries, PassagesAgreeWithAllFacets) {
  std::array<int, 3> seen{};
  for (std::uint64_t seed = 0; seed < test_rounds(60U); ++seed) {
    Random random(seed);
    const Points a = on_a_small_grid(random, 4, 6);
    const Points b = on_a_small_grid(random, 4, 6);
    if (convex_hull(a, one_thread).dimension < 3 || convex_hull(b, one_thread).dimension < 3) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Pair pair{a, b};
    ProximityHint hint;
    const auto draw = [&] { return below(random, 15) - 7.0; };
    Vector3 from{draw(), draw(), draw()};
    for (int round = 0; round < 12; ++round) {
      const Vector3 to = round % 3 == 0 ? Vector3{from.x, from.y, draw()} : Vector3{draw(), draw(), draw()};
      check_passage(pair, from, to, hint, seen);
      if (HasFailure()) return;
      from = to;
    }
  }
  for (const int count : seen) EXPECT_GE(count, test_cases(10));
  // Over a cube: down on it, along its top, off; a corner grazed; through.
  const Pair pair{cube, cube};
  ProximityHint hint;
  const auto passage = [&](const Vector3& from, const Vector3& to) {
    return pair.queries.passage(from, to, hint, one_thread);
  };
  EXPECT_EQ(passage({0, 0, 4}, {0, 0, 0}).enter, Rational(3) / Rational(4));
  EXPECT_EQ(passage({-4, 0, 1}, {4, 0, 1}).relation, Proximity::touching);
  EXPECT_EQ(passage({-4, 0, 1}, {4, 0, 1}).leave, Rational(5) / Rational(8));
  EXPECT_EQ(passage({0, 2, 1}, {2, 0, 1}).enter, Rational(1) / Rational(2));
  EXPECT_EQ(passage({0, 2, 0}, {2, 0, 0}).relation, Proximity::touching);
  EXPECT_EQ(passage({-2, 0, 0}, {1, 0, 0}).relation, Proximity::overlapping);
  EXPECT_EQ(passage({1, 0, 0}, {1, 0, 0}).relation, Proximity::touching);
  EXPECT_EQ(passage({0.5, 0, 0}, {0.5, 0, 0}).leave, Rational(1));
}

TEST(TranslationFilters, AgreeWithExactSigns) {
  std::array<std::uint64_t, 2> decided{};
  for (std::uint64_t seed = 0; seed < test_rounds(30U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::normal_distribution<double> normal;
    const auto draw = [&](int count, double away, double size) {
      Points points;
      for (int i = 0; i < count; ++i) {
        points.push_back({normal(random) * size + away, normal(random) * size, normal(random) * size});
      }
      return points;
    };
    constexpr std::array<double, 4> sizes{1, 1e-150, 1e55, 1e250};
    const double size = sizes.at(seed % 4);
    const TranslationBody body(polytope(draw(15, size * static_cast<double>(seed), size)),
                               polytope(draw(15, 0, size * 3)), one_thread);
    const TranslationFilters filters(body, one_thread);
    const auto compare = [&](int sign, Sign exact) {
      ++decided.at(sign != 0 ? 1 : 0);
      if (sign != 0) {
        EXPECT_EQ(sign, to_int(exact));
      }
    };
    for (int round = 0; round < 60; ++round) {
      const auto rim = static_cast<std::uint32_t>(random() % body.rim_count());
      const std::uint32_t f = body.facet_of(rim);
      const RationalPoint3 at = round % 2 == 0
                                    ? body.exact(body.tail(rim))
                                    : (body.exact(body.tail(rim)) + body.exact(body.head(rim))) * Rational(0.5);
      const double off = round % 3 == 0 ? 0 : std::ldexp(size, -15 * (round % 5));
      const Point3 t{at.x.to_double() + off * normal(random), at.y.to_double() + off * normal(random),
                     at.z.to_double() + off * normal(random)};
      const Vector3 direction{normal(random), normal(random), normal(random)};
      const auto query = filters.query(t);
      compare(filters.height(f, query), body.height(f, t));
      compare(filters.seen(rim, query), body.seen(rim, t));
      compare(filters.along(body.tail(rim), body.head(rim), query), body.along(rim, t));
      compare(filters.across(f, body.tail(rim), body.head(rim), query), body.across(rim, t));
      compare(filters.seen_along(body.tail(rim), body.head(rim), query, direction), body.seen_along(rim, t, direction));
    }
    if (HasFailure()) return;
  }
  EXPECT_GE(decided[1], test_cases(2000U));
  EXPECT_GE(decided[0], test_cases(100U));
}

TEST(ProximityQueries, OfAnySize) {
  for (const double size : {0x1p-1060, 0x1p-500, 0x1p300, 0x1p900, 0x1p1000}) {
    Points a = corner;
    Points b = cube;
    for (Point3& p : a) p = {p.x * size, p.y * size, p.z * size};
    for (Point3& p : b) p = {p.x * size, p.y * size, p.z * size};
    const ProximityQueries queries(polytope(a), polytope(b), one_thread);
    ProximityHint hint;
    EXPECT_EQ(queries.relation({-4 * size, 0, 0}, hint).relation, Proximity::touching);
    EXPECT_EQ(queries.relation({-3 * size, 0, 0}, hint).relation, Proximity::overlapping);
    EXPECT_EQ(queries.distance({3 * size, 0, 0}, hint).squared_distance, Rational(4) * Rational(size) * Rational(size));
    EXPECT_TRUE(queries.nearest({3 * size, 0, 0}, hint)
                    .squared_distance.contains(Rational(4) * Rational(size) * Rational(size)));
    EXPECT_EQ(queries.penetration({-3 * size, 0, 0}, {-4, 0, 0}, hint).depth, Rational(size) / Rational(4));
  }
}

TEST(ProximityQueries, RefuseWhatIsNoTranslation) {
  const Polytope square = polytope({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  EXPECT_THROW(ProximityQueries(square, square, one_thread), InputError);
  const ProximityQueries queries(polytope(cube), square, one_thread);
  ProximityHint hint;
  EXPECT_EQ(queries.relation({0, 0, -1}, hint).relation, Proximity::touching);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const Vector3& wrong : {Vector3{nan, 0, 0}, Vector3{0, infinite, 0}, Vector3{0, 0, -infinite}}) {
    EXPECT_THROW(queries.relation(wrong, hint), InputError);
    EXPECT_THROW(queries.distance(wrong, hint), InputError);
    EXPECT_THROW(queries.penetration({0, 0, 0}, wrong, hint), InputError);
  }
  EXPECT_THROW(queries.penetration({0, 0, 0}, {0, 0, 0}, hint), InputError);
  hint.facet = 1000000;  // of another body
  EXPECT_EQ(queries.relation({0, 0, -1}, hint).relation, Proximity::touching);
}

TEST(ProximityQueries, TakeFewStepsAlongAPath) {
  Points points;
  Random random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 300; ++i) {
    const Vector3 p{normal(random), normal(random), normal(random)};
    const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    points.push_back({p.x / length, p.y / length, p.z / length});
  }
  const ProximityQueries queries(polytope(points), polytope(points), one_thread);
  ProximityHint hint;
  std::uint64_t without = 0;
  constexpr int count = 2000;
  for (int i = 0; i < count; ++i) {
    const double angle = 0.002 * i;
    const Vector3 t{1.9 * std::cos(angle), 1.9 * std::sin(angle), std::sin(3 * angle)};
    const TranslationRelation found = queries.relation(t, hint);
    ProximityHint fresh;
    EXPECT_EQ(queries.relation(t, fresh).relation, found.relation);
    without += fresh.steps;
  }
  EXPECT_LT(hint.steps, count);
  EXPECT_LT(without, 12 * count);
}

}  // namespace
}  // namespace quoin
