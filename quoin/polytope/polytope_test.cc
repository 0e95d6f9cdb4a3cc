// SPDX-License-Identifier: Apache-2.0
//
// The record of a polytope in every dimension, of doubles and of rationals, and reflected.
#include "quoin/polytope/polytope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/test_sums.h"

namespace quoin {
namespace {

using namespace test_polytopes;
using RationalPoints = std::vector<RationalPoint3>;

/// Facets by the exact coordinates of their corners, written out, from the smallest.
std::set<std::vector<std::string>> facets_of(const Polytope& p) {
  std::set<std::vector<std::string>> facets;
  for (std::uint32_t f = 0; f < p.facet_count(); ++f) {
    std::vector<std::string> facet;
    std::uint32_t h = p.first_halfedge(f);
    do {
      const RationalPoint3 v = p.exact_vertex(p.halfedges()[h].tail);
      facet.push_back(v.x.to_string() + " " + v.y.to_string() + " " + v.z.to_string());
      h = p.halfedges()[h].next;
    } while (h != p.first_halfedge(f));
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
    facets.insert(facet);
  }
  return facets;
}

/// Links agree with one another, numbers run counterclockwise about vertices, vectors are those between vertices, and
/// nothing lies outside of a facet.
void check_record(const Polytope& p) {
  ASSERT_EQ(p.facet_count() == 0, p.dimension() < 2);
  ASSERT_EQ(p.end_out(static_cast<std::uint32_t>(p.vertex_count()) - 1), p.halfedges().size());
  std::vector<std::uint32_t> previous(p.halfedges().size());
  for (std::uint32_t h = 0; h < p.halfedges().size(); ++h) previous[p.halfedges()[h].next] = h;
  for (std::uint32_t h = 0; h < p.halfedges().size(); ++h) {
    const Polytope::Halfedge& halfedge = p.halfedges()[h];
    const Polytope::Halfedge& next = p.halfedges()[halfedge.next];
    ASSERT_EQ(p.halfedges()[halfedge.twin].twin, h);
    ASSERT_EQ(p.halfedges()[halfedge.twin].head, halfedge.tail);
    ASSERT_EQ(next.tail, halfedge.head);
    ASSERT_EQ(next.facet, halfedge.facet);
    ASSERT_TRUE(p.first_out(halfedge.tail) <= h && h < p.end_out(halfedge.tail));
    const std::uint32_t counterclockwise = h + 1 < p.end_out(halfedge.tail) ? h + 1 : p.first_out(halfedge.tail);
    if (p.dimension() > 1) {
      ASSERT_EQ(p.halfedges()[previous[h]].twin, counterclockwise);
    }
    ASSERT_EQ(exact_vector(p.edge(h)), p.exact_vertex(halfedge.head) - p.exact_vertex(halfedge.tail));
  }
  for (std::uint32_t f = 0; f < p.facet_count(); ++f) {
    const std::uint32_t h = p.first_halfedge(f);
    const RationalPoint3 normal = cross(exact_vector(p.edge(h)), exact_vector(p.edge(p.halfedges()[h].next)));
    const RationalPoint3 origin = p.exact_vertex(p.halfedges()[h].tail);
    for (std::uint32_t v = 0; v < p.vertex_count(); ++v) {
      ASSERT_NE(dot(normal, p.exact_vertex(v) - origin).sign(), Sign::positive);
    }
  }
}

RationalPoints times(const Points& points, const Rational& factor) {
  RationalPoints result;
  for (const Point3& p : points) result.push_back(exact_point(p) * factor);
  return result;
}

TEST(Polytope, ReflectedIsTheHullOfNegatedPoints) {
  for (std::uint64_t seed = 0; seed < test_rounds(500U); ++seed) {
    Random random(seed);
    const Points points = seed % 5 == 4 ? on_a_small_grid(random, 4, 20) : on_a_small_flat(random, int(seed % 5));
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (const Rational& factor : {Rational(1), Rational(1) / Rational(3)}) {
      const Polytope p = Polytope::hull_of(times(points, factor), one_thread);
      const Polytope q = reflected(p);
      ASSERT_NO_FATAL_FAILURE(check_record(p));
      ASSERT_NO_FATAL_FAILURE(check_record(q));
      const Polytope expected = Polytope::hull_of(times(points, -factor), one_thread);
      ASSERT_EQ(q.dimension(), expected.dimension());
      ASSERT_EQ(facets_of(q), facets_of(expected));
      ASSERT_EQ(facets_of(reflected(q)), facets_of(p));
      for (std::uint32_t v = 0; v < p.vertex_count(); ++v) {
        ASSERT_EQ(q.source(v), p.source(v));
        ASSERT_EQ(q.exact_vertex(v), p.exact_vertex(v) * Rational(-1));
      }
      const PolytopeSum sum = minkowski_sum(p, q, one_thread);
      if (factor != Rational(1)) continue;
      ASSERT_EQ(cells_of_sum(sum, exact_vertices(sum, p, q)),
                cells_of_hull(all_sums(std::array{points, scaled(points, -1)})));
    }
  }
}

// A third of all coordinates changes nothing but the kind of numbers; and both kinds may meet in a sum.
TEST(Polytope, OfRationalsSumsLikeOfDoubles) {
  int rational = 0;
  for (std::uint64_t seed = 0; seed < test_rounds(300U); ++seed) {
    Random random(seed);
    const Points a = seed % 3 == 0 ? on_a_small_grid(random, 4, 8) : on_a_small_flat(random, below(random, 4));
    const Points b = on_a_small_flat(random, below(random, 4));
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto labels = [](const PolytopeSum& sum) {
      std::set<std::vector<std::array<std::uint32_t, 2>>> facets;
      for (std::size_t f = 0; f < sum.facet_count(); ++f) {
        std::vector<std::array<std::uint32_t, 2>> facet;
        for (const std::uint32_t v : sum.facet(f)) facet.push_back(sum.vertices[v]);
        std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
        facets.insert(facet);
      }
      return facets;
    };
    const Polytope p = Polytope::hull_of(a, one_thread);
    const Polytope q = Polytope::hull_of(b, one_thread);
    const Rational third = Rational(1) / Rational(3);
    const Polytope p3 = Polytope::hull_of(times(a, third), one_thread);
    const Polytope q3 = Polytope::hull_of(times(b, third), one_thread);
    rational += p3.is_rational() && q3.is_rational() ? 1 : 0;
    const auto expected = labels(minkowski_sum(p, q, one_thread));
    ASSERT_EQ(labels(minkowski_sum(p3, q3, one_thread)), expected);
    // Factors do not change the map of a polytope.
    ASSERT_EQ(labels(minkowski_sum(p, q3, one_thread)), expected);
    const Polytope huge = Polytope::hull_of(times(a, third * Rational(0x1p1000)), one_thread);
    const Polytope tiny = Polytope::hull_of(times(b, third * Rational(0x1p-1074)), one_thread);
    ASSERT_EQ(labels(minkowski_sum(huge, tiny, one_thread)), expected);
  }
  EXPECT_GE(rational, test_cases(150));
}

TEST(Polytope, OfEveryDimension) {
  const auto counts = [](const Points& points) {
    const Polytope p = Polytope::hull_of(points, one_thread);
    check_record(p);
    return std::array<std::size_t, 4>{static_cast<std::size_t>(p.dimension()), p.vertex_count(), p.edge_count(),
                                      p.facet_count()};
  };
  using Expected = std::array<std::size_t, 4>;
  EXPECT_EQ(counts({{1, 2, 3}, {1, 2, 3}}), (Expected{0, 1, 0, 0}));
  EXPECT_EQ(counts({{1, 2, 3}, {3, 4, 5}, {2, 3, 4}}), (Expected{1, 2, 1, 0}));
  EXPECT_EQ(counts({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Expected{2, 4, 4, 2}));
  EXPECT_EQ(counts(cube), (Expected{3, 8, 12, 6}));
  EXPECT_THROW(Polytope::hull_of(RationalPoints{}, one_thread), InputError);
  EXPECT_THROW(Polytope::hull_of(Points{{0, 0, 1 / 0.0}}, one_thread), InputError);
}

/// Of a polytope with the origin inside: a vertex for each facet, where rationals are exact and doubles are not.
RationalPoints polar_dual(const Polytope& p) {
  RationalPoints result;
  for (std::uint32_t f = 0; f < p.facet_count(); ++f) {
    const std::uint32_t h = p.first_halfedge(f);
    const RationalPoint3 normal = cross(exact_vector(p.edge(h)), exact_vector(p.edge(p.halfedges()[h].next)));
    result.push_back(normal * (Rational(1) / dot(normal, p.exact_vertex(p.halfedges()[h].tail))));
  }
  return result;
}

// Minkowski thesis, section 3.1: duals of rounded simplicial polytopes are simple ones with facets exactly planar. And
// back; and the sum with the reflection, which is the same in another size.
TEST(Polytope, PolarDualsOfRoundedPolytopes) {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  Points axes;
  const auto add_cyclic = [&](double a, double b, double c) {
    const double length = std::sqrt(a * a + b * b + c * c);
    const auto round = [&](double x) { return std::round(1000 * x / length); };
    for (int signs = 0; signs < 8; ++signs) {
      const double x = (signs & 1) != 0 ? -round(a) : round(a);
      const double y = (signs & 2) != 0 ? -round(b) : round(b);
      const double z = (signs & 4) != 0 ? -round(c) : round(c);
      axes.insert(axes.end(), {{x, y, z}, {y, z, x}, {z, x, y}});
    }
  };
  const auto check = [](const Points& points, const Counts& expected) {
    const Polytope p = Polytope::hull_of(points, one_thread);
    const Polytope dual = Polytope::hull_of(polar_dual(p), one_thread);
    check_record(dual);
    EXPECT_TRUE(dual.is_rational());
    EXPECT_EQ((Counts{dual.vertex_count(), dual.edge_count(), dual.facet_count()}), expected);
    const Polytope back = Polytope::hull_of(polar_dual(dual), one_thread);
    EXPECT_FALSE(back.is_rational());
    EXPECT_EQ(facets_of(back), facets_of(p));
    const PolytopeSum sum = minkowski_sum(dual, reflected(dual), one_thread);
    EXPECT_EQ((Counts{sum.vertex_count(), sum.edge_count(), sum.facet_count()}), expected);
  };
  check(icosahedron(), {20, 30, 12});
  // All axes of the icosahedron: the dual is the truncated icosidodecahedron.
  add_cyclic(0, 1, golden);
  add_cyclic(1, 1, 1);
  add_cyclic(0, 1 / golden, golden);
  add_cyclic(0, 0, 1);
  add_cyclic(1 / golden, 1, golden);
  check(axes, {120, 180, 62});
}

TEST(Polytope, CopiesOfRationalsOutliveTheOriginal) {
  std::vector<Polytope> copies;
  {
    const Polytope p = Polytope::hull_of(times(cube, Rational(1) / Rational(7)), one_thread);
    copies.push_back(p);
    copies.push_back(reflected(p));
  }
  for (const Polytope& copy : copies) check_record(copy);
  EXPECT_EQ(minkowski_sum(copies[0], copies[1], one_thread).facet_count(), 6U);
}

}  // namespace
}  // namespace quoin
