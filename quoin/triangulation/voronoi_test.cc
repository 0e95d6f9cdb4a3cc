// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/voronoi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/triangulation/delaunay_location.h"
#include "quoin/triangulation/test_clouds.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::Random;

Delaunay3 triangulated(const std::vector<Point3>& points) {
  const Context context({.threads = 1});
  return Delaunay3(points, context);
}

Rational square_distance(const RationalPoint3& a, const RationalPoint3& b) {
  return dot(a - b, a - b);
}

TEST(Circulators, RingsAndStarsAreComplete) {
  Random random(21);
  for (const Cloud& cloud : testing::clouds(random, 20)) {
    SCOPED_TRACE(cloud.name);
    const Delaunay3 t = triangulated(cloud.points);
    const VertexStars stars(t);
    const auto size = static_cast<unsigned>(t.dimension()) + 1;
    for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
      std::vector<std::uint32_t> expected;
      for (std::uint32_t c = 0; c < t.cells().size(); ++c) {
        const auto& w = t.cells()[c].vertices;
        if (std::find(w.begin(), w.begin() + size, v) != w.begin() + size) expected.push_back(c);
      }
      std::vector<std::uint32_t> star = stars.star(v);
      std::sort(star.begin(), star.end());
      ASSERT_EQ(star, expected);
    }
    if (size < 4) continue;
    for (std::uint32_t c = 0; c < t.cells().size(); ++c) {
      const auto& v = t.cells()[c].vertices;
      std::set<std::uint32_t> expected;
      for (std::uint32_t other = 0; other < t.cells().size(); ++other) {
        const auto& w = t.cells()[other].vertices;
        if (std::count(w.begin(), w.end(), v[0]) + std::count(w.begin(), w.end(), v[2]) == 2) expected.insert(other);
      }
      std::vector<std::uint32_t> ring;
      for_each_around_edge(t.cells(), c, 0, 2, [&](std::uint32_t other) { ring.push_back(other); });
      ASSERT_EQ(ring.size(), expected.size());
      ASSERT_EQ(std::set<std::uint32_t>(ring.begin(), ring.end()), expected);
    }
  }
}

TEST(Voronoi3, CornersAreNearestToTheirVertices) {
  Random random(22);
  const std::vector<Point3> points = testing::random_points(random, 25, testing::unit);
  const Delaunay3 t = triangulated(points);
  const Voronoi3 voronoi(t);
  for (std::size_t c = 0; c < t.cells().size(); ++c) {
    if (t.is_ghost(c)) continue;
    const RationalPoint3 corner = voronoi.corner(c);
    const Rational radius = square_distance(corner, exact_point(t.point(t.cells()[c].vertices[0])));
    for (std::uint32_t q = 0; q < t.vertex_count(); ++q) {
      const bool is_of_cell = std::count(t.cells()[c].vertices.begin(), t.cells()[c].vertices.end(), q) != 0;
      const Rational distance = square_distance(corner, exact_point(t.point(q)));
      ASSERT_TRUE(is_of_cell ? distance == radius : distance >= radius);
    }
  }
}

TEST(Voronoi3, CubesOfALattice) {
  const Delaunay3 t = triangulated(testing::lattice(4, 4, 4));
  const Voronoi3 voronoi(t);
  int inner = 0;
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
    const Point3 p = t.point(v);
    const bool is_inner = std::min({p.x, p.y, p.z}) > 0 && std::max({p.x, p.y, p.z}) < 3;
    const std::optional<Rational> volume = voronoi.volume(v);
    ASSERT_EQ(volume.has_value(), is_inner);
    std::size_t sides = 0;  // with another cube beyond
    for (const double x : {p.x, p.y, p.z}) sides += x > 0 && x < 3 ? 2 : 1;
    ASSERT_EQ(voronoi.facets(v).size(), sides);
    if (!is_inner) continue;
    ++inner;
    EXPECT_EQ(*volume, Rational(1));
    const std::vector<VoronoiFacet> facets = voronoi.facets(v);
    EXPECT_EQ(facets.size(), 6U);
    for (const VoronoiFacet& facet : facets) EXPECT_EQ(facet.corners.size(), 4U);
  }
  EXPECT_EQ(inner, 8);
}

TEST(Voronoi3, CornersOfACubeHaveThreeFacets) {
  const Delaunay3 t = triangulated(testing::lattice(2, 2, 2));
  const Voronoi3 voronoi(t);
  for (std::uint32_t v = 0; v < 8; ++v) {
    const std::vector<VoronoiFacet> facets = voronoi.facets(v);
    ASSERT_EQ(facets.size(), 3U);
    for (const VoronoiFacet& facet : facets) {
      EXPECT_FALSE(facet.is_bounded);
      EXPECT_EQ(facet.corners.size(), 1U);
      EXPECT_EQ(square_distance(exact_point(t.point(v)), exact_point(t.point(facet.neighbour))), Rational(1));
    }
  }
}

/// Cells of a large cube's lattice with one random point moved: they still fill what they filled.
TEST(Voronoi3, VolumesOfAllCellsFillSpace) {
  Random random(23);
  for (int round = 0; round < test_rounds(5); ++round) {
    // Mirror images of the points in the six sides of a cube make its sides facets of the diagram.
    const std::vector<Point3> inner =
        testing::random_points(random, 12, [](Random& r) { return static_cast<double>(1 + r() % 63) / 64; });
    std::vector<Point3> points = inner;
    for (const Point3& p : inner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double side : {0.0, 2.0}) {
          Point3 q = p;
          q[axis] = side - p[axis];
          points.push_back(q);
        }
      }
    }
    const Delaunay3 t = triangulated(points);
    const Voronoi3 voronoi(t);
    Rational sum;
    for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
      if (t.inputs(v)[0] >= inner.size()) continue;
      const std::optional<Rational> volume = voronoi.volume(v);
      ASSERT_TRUE(volume.has_value());
      EXPECT_GT(*volume, Rational(0));
      EXPECT_EQ(*volume, voronoi.volume(v, voronoi.facets(v)));
      sum += *volume;
    }
    EXPECT_EQ(sum, Rational(1));
  }
}

TEST(Voronoi3, VolumesAreThoseOfTheirFacets) {
  Random random(24);
  for (const testing::Cloud& cloud : testing::clouds(random, 24)) {
    SCOPED_TRACE(cloud.name);
    const Delaunay3 t = triangulated(cloud.points);
    if (t.dimension() < 3) continue;
    const Voronoi3 voronoi(t);
    for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
      if (voronoi.is_unbounded(v)) continue;
      ASSERT_EQ(*voronoi.volume(v), voronoi.volume(v, voronoi.facets(v)));
    }
  }
}

TEST(Voronoi3, SectionsAreOfFlatPoints) {
  const Delaunay3 t = triangulated(testing::lattice(2, 2, 2));
  EXPECT_THROW(Voronoi3(t).squared_section(0), InputError);
}

TEST(DelaunayLocator, FacesOfAllDimensions) {
  Random random(24);
  for (const Cloud& cloud : testing::clouds(random, 30)) {
    SCOPED_TRACE(cloud.name);
    const Delaunay3 t = triangulated(cloud.points);
    const DelaunayLocator locator(t);
    if (t.dimension() < 3) continue;
    for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
      const DelaunayLocation found = locator.locate(t.point(v));
      ASSERT_EQ(found.kind, DelaunayLocation::Kind::vertex);
      for (unsigned i = 0; i < 4; ++i) {
        if ((found.slots >> i & 1) == 0) continue;
        ASSERT_EQ(t.cells()[found.cell].vertices[i], v);
      }
    }
  }
  const Delaunay3 cube = triangulated(testing::lattice(2, 2, 2));
  const DelaunayLocator locator(cube);
  EXPECT_EQ(locator.locate({0.5, 0, 0}).kind, DelaunayLocation::Kind::edge);
  EXPECT_EQ(locator.locate({0.5, 0.25, 0}).kind, DelaunayLocation::Kind::facet);
  EXPECT_EQ(locator.locate({0.5, 0.26, 1.5}).kind, DelaunayLocation::Kind::outside);
  EXPECT_THROW(locator.locate({0, std::numeric_limits<double>::quiet_NaN(), 0}), InputError);
}

TEST(DelaunayLocator, NearestByBruteForce) {
  Random random(25);
  for (const Cloud& cloud : testing::clouds(random, 30)) {
    SCOPED_TRACE(cloud.name);
    const Delaunay3 t = triangulated(cloud.points);
    const DelaunayLocator locator(t);
    for (int round = 0; round < test_rounds(10); ++round) {
      const Point3& a = cloud.points[random() % cloud.points.size()];
      const Point3& b = cloud.points[random() % cloud.points.size()];
      const Point3 q{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2,
                     random() % 2 == 0 ? a.z / 2 + b.z / 2 : testing::unit(random)};
      std::uint32_t best = 0;
      for (std::uint32_t v = 1; v < t.vertex_count(); ++v) {
        if (square_distance(exact_point(t.point(v)), exact_point(q)) <
            square_distance(exact_point(t.point(best)), exact_point(q))) {
          best = v;
        }
      }
      ASSERT_EQ(locator.nearest(q), best);
    }
  }
}

}  // namespace
}  // namespace quoin
