// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay3.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/triangulation/test_clouds.h"
#include "quoin/triangulation/test_memory.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::Random;

Delaunay3 triangulated(const std::vector<Point3>& points, const DelaunayOptions& options = {}) {
  const Context context({.threads = 1});
  return Delaunay3(points, context, options);
}

std::array<Point3, 4> corners(const Delaunay3& t, std::size_t cell) {
  const auto& v = t.cells()[cell].vertices;
  return {t.point(v[0]), t.point(v[1]), t.point(v[2]), t.point(v[3])};
}

/// Neighbours know each other and share their facets.
void expect_adjacent(const Delaunay3& t) {
  const auto d = static_cast<unsigned>(t.dimension());
  for (std::uint32_t c = 0; c < t.cells().size(); ++c) {
    const TriangulationCell& cell = t.cells()[c];
    for (unsigned i = 0; i <= d; ++i) {
      const std::uint32_t mate = cell.neighbours[i];
      ASSERT_LT(mate >> 2, t.cells().size());
      const TriangulationCell& other = t.cells()[mate >> 2];
      ASSERT_EQ(other.neighbours[mate & 3], c * 4 + i);
      std::multiset<std::uint32_t> here(cell.vertices.begin(), cell.vertices.begin() + d + 1);
      std::multiset<std::uint32_t> there(other.vertices.begin(), other.vertices.begin() + d + 1);
      here.erase(here.find(cell.vertices[i]));
      there.erase(there.find(other.vertices[mate & 3]));
      ASSERT_EQ(here, there);
    }
  }
}

/// By the predicates of the kernel, which share no filter of all points with the triangulation.
void expect_empty_spheres(const Delaunay3& t) {
  const auto count = static_cast<std::uint32_t>(t.vertex_count());
  for (std::size_t c = 0; c < t.cells().size(); ++c) {
    if (t.dimension() < 3) break;
    const auto& v = t.cells()[c].vertices;
    if (t.is_ghost(c)) {
      for (std::uint32_t q = 0; q < count; ++q) {
        ASSERT_LE(to_int(orientation(t.point(v[0]), t.point(v[1]), t.point(v[2]), t.point(q))), 0);
      }
      continue;
    }
    const auto [p0, p1, p2, p3] = corners(t, c);
    ASSERT_EQ(orientation(p0, p1, p2, p3), Sign::positive);
    for (std::uint32_t q = 0; q < count; ++q) ASSERT_LE(to_int(in_sphere(p0, p1, p2, p3, t.point(q))), 0);
  }
}

void expect_empty_circles(const Delaunay3& t) {
  const DelaunaySigns signs = t.signs();
  for (std::size_t c = 0; c < t.cells().size(); ++c) {
    if (t.is_ghost(c)) continue;
    for (std::uint32_t q = 0; q < t.vertex_count(); ++q) ASSERT_LE(t.in_sphere(signs, c, q), 0);
  }
}

/// Distinct faces of all dimensions, without infinity: the sum with signs is 1.
void expect_euler(const Delaunay3& t) {
  std::set<std::vector<std::uint32_t>> faces;
  for (std::size_t c = 0; c < t.cells().size(); ++c) {
    if (t.is_ghost(c)) continue;
    const auto& v = t.cells()[c].vertices;
    const unsigned size = static_cast<unsigned>(t.dimension()) + 1;
    for (unsigned mask = 1; mask < 1U << size; ++mask) {
      std::vector<std::uint32_t> face;
      for (unsigned i = 0; i < size; ++i) {
        if ((mask >> i & 1) != 0) face.push_back(v[i]);
      }
      std::sort(face.begin(), face.end());
      faces.insert(face);
    }
  }
  int sum = 0;
  std::size_t vertices = 0;
  for (const auto& face : faces) {
    sum += face.size() % 2 == 1 ? 1 : -1;
    vertices += face.size() == 1 ? 1 : 0;
  }
  EXPECT_EQ(sum, 1);
  EXPECT_EQ(vertices, t.vertex_count());
}

/// Every input is at its vertex, once.
void expect_inputs(const Delaunay3& t, const std::vector<Point3>& points) {
  std::vector<int> seen(points.size(), 0);
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
    ASSERT_TRUE(std::is_sorted(t.inputs(v).begin(), t.inputs(v).end()));
    for (const std::uint32_t i : t.inputs(v)) {
      ++seen[i];
      ASSERT_EQ(t.point(v), points[i]);
    }
  }
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
}

bool same_cells(const Delaunay3& a, const Delaunay3& b) {
  return std::equal(a.cells().begin(), a.cells().end(), b.cells().begin(), b.cells().end(),
                    [](const TriangulationCell& x, const TriangulationCell& y) {
                      return x.vertices == y.vertices && x.neighbours == y.neighbours;
                    });
}

TEST(Delaunay3, SpheresAreEmptyInAllFamilies) {
  Random random(1);
  for (std::size_t size = 7; size < 28; size += 10) {
    for (const Cloud& cloud : testing::clouds(random, size)) {
      SCOPED_TRACE(cloud.name);
      for (const bool is_canonical : {false, true}) {
        const Delaunay3 t = triangulated(cloud.points, {.is_canonical = is_canonical});
        expect_adjacent(t);
        expect_empty_spheres(t);
        expect_empty_circles(t);
        expect_euler(t);
        expect_inputs(t, cloud.points);
        ASSERT_FALSE(HasFatalFailure());
      }
    }
  }
}

TEST(Delaunay3, SameBytesInAnyOrder) {
  Random random(2);
  for (Cloud& cloud : testing::clouds(random, 60)) {
    SCOPED_TRACE(cloud.name);
    const Delaunay3 first = triangulated(cloud.points);
    for (int round = 0; round < test_rounds(5); ++round) {
      std::shuffle(cloud.points.begin(), cloud.points.end(), random);
      EXPECT_TRUE(same_cells(first, triangulated(cloud.points)));
    }
  }
}

/// Some of the points lie in one cell of the curve, too few to divide it further, and more than that when given twice.
TEST(Delaunay3, SameBytesForPointsGivenTwice) {
  Random random(7);
  for (const std::size_t count : {6U, 10U, 14U, 18U}) {
    for (const Cloud& cloud : testing::clouds(random, 10)) {
      SCOPED_TRACE(cloud.name);
      std::vector<Point3> points = cloud.points;
      for (Point3 p : testing::random_points(random, count, testing::unit)) {
        points.push_back({p.x * 0x1p-20, p.y * 0x1p-20, p.z * 0x1p-20});
      }
      points.push_back({1, 1, 1});
      const Delaunay3 once = triangulated(points);
      const std::vector<Point3> copy = points;
      points.insert(points.end(), copy.begin(), copy.end());
      points.insert(points.end(), 100, points[0]);
      const Delaunay3 twice = triangulated(points);
      ASSERT_EQ(once.vertex_count(), twice.vertex_count());
      for (std::uint32_t v = 0; v < once.vertex_count(); ++v) ASSERT_EQ(once.point(v), twice.point(v));
      EXPECT_TRUE(same_cells(once, twice));
    }
  }
}

TEST(Delaunay3, SameBytesForBothZeros) {
  std::vector<Point3> points = testing::lattice(2, 2, 2);
  const Delaunay3 first = triangulated(points);
  for (Point3& p : points) p = {p.x == 0 ? -0.0 : p.x, p.y, p.z == 0 ? -0.0 : p.z};
  points.push_back({0, 0, 0});
  const Delaunay3 second = triangulated(points);
  EXPECT_TRUE(same_cells(first, second));
  EXPECT_EQ(second.vertex_count(), 8U);
}

TEST(Delaunay3, LargeCloudsAreLocallyDelaunay) {
  Random random(3);
  std::vector<Cloud> all{{"uniform", testing::random_points(random, test_rounds(20000U), testing::unit)},
                         {"sphere", testing::near_sphere(random, test_rounds(5000U))},
                         {"lattice", testing::lattice(14, 15, 13)},
                         {"grid", testing::random_points(random, test_rounds(10000U),
                                                         [](Random& r) { return testing::small_integer(r, 50); })}};
  for (const Cloud& cloud : all) {
    SCOPED_TRACE(cloud.name);
    const Delaunay3 t = triangulated(cloud.points);
    expect_adjacent(t);
    for (std::uint32_t c = 0; c < t.cells().size(); ++c) {
      if (t.is_ghost(c)) continue;
      const auto [p0, p1, p2, p3] = corners(t, c);
      ASSERT_EQ(orientation(p0, p1, p2, p3), Sign::positive);
      for (const std::uint32_t mate : t.cells()[c].neighbours) {
        const std::uint32_t q = t.cells()[mate >> 2].vertices[mate & 3];
        if (q == vertex_at_infinity) continue;
        ASSERT_LE(to_int(in_sphere(p0, p1, p2, p3, t.point(q))), 0);
      }
    }
  }
}

/// A star of more vertices than the table of edges holds.
TEST(Delaunay3, LargeStars) {
  Random random(4);
  std::vector<Point3> points = testing::near_sphere(random, 400);
  points.push_back({0, 0, 0});
  points.push_back({1e-3, 2e-3, -1e-3});
  const Delaunay3 t = triangulated(points);
  expect_adjacent(t);
  expect_empty_spheres(t);
  expect_euler(t);
}

TEST(Delaunay3, DimensionsOfFlats) {
  EXPECT_EQ(triangulated(testing::lattice(1, 1, 1)).dimension(), 0);
  EXPECT_EQ(triangulated(testing::lattice(1, 5, 1)).dimension(), 1);
  EXPECT_EQ(triangulated(testing::lattice(4, 5, 1)).dimension(), 2);
  EXPECT_EQ(triangulated(testing::lattice(1, 5, 4)).dimension(), 2);
  EXPECT_EQ(triangulated(testing::lattice(4, 5, 2)).dimension(), 3);
  EXPECT_EQ(triangulated(testing::lattice(4, 4, 1)).finite_cell_count(), 18U);
  // One unit in the last place off the plane is another dimension.
  std::vector<Point3> points = testing::lattice(4, 4, 1);
  for (Point3& p : points) p.z = 1e10;
  EXPECT_EQ(triangulated(points).dimension(), 2);
  points[7].z = std::nextafter(1e10, 2e10);
  EXPECT_EQ(triangulated(points).dimension(), 3);
}

TEST(Delaunay3, RefusesWhatIsNoPoint) {
  const auto message = [](const std::vector<Point3>& points) -> std::string {
    try {
      triangulated(points);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message({}).find("no points"), std::string::npos);
  std::vector<Point3> points = testing::lattice(2, 2, 2);
  points[5].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message(points).find("point 5 "), std::string::npos);
  points[5].y = -std::numeric_limits<double>::infinity();
  EXPECT_NE(message(points).find("point 5 "), std::string::npos);
}

TEST(Delaunay3, TooLittleMemoryIsSaid) {
  const Context context({.threads = 1});
  for (const std::vector<Point3>& points :
       {testing::lattice(3, 2, 3), testing::lattice(3, 4, 1), testing::lattice(1, 4, 1), testing::lattice(1, 1, 1)}) {
    bool has_failed = true;
    for (std::size_t allocation = 0; has_failed; ++allocation) {
      const testing::FailingAllocation failing(allocation);
      try {
        const Delaunay3 t(points, context, {.is_canonical = true});
        ASSERT_FALSE(failing.has_failed()) << allocation;
        has_failed = false;
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find("too little memory"), 0U) << error.what();
      }
    }
  }
}

TEST(Delaunay3, MayBeCancelled) {
  Random random(5);
  const std::vector<Point3> points = testing::random_points(random, 20000, testing::unit);
  Context context({.threads = 1});
  context.cancel();
  EXPECT_THROW(Delaunay3(points, context), Cancelled);
  Context* running = nullptr;
  Context during({.threads = 1, .progress = [&running](std::string_view, double done) {
                    if (done > 0.5) running->cancel();
                  }});
  running = &during;
  EXPECT_THROW(Delaunay3(points, during), Cancelled);
}

/// Signs of the triangulation against those of the kernel, over points biased to degeneracy.
TEST(DelaunaySigns, AgreeWithTheKernel) {
  Random random(6);
  for (int round = 0; round < test_rounds(10); ++round) {
    for (const Cloud& cloud : testing::clouds(random, 12)) {
      SCOPED_TRACE(cloud.name);
      const std::vector<Point3>& p = cloud.points;
      const DelaunaySigns signs(p, false);
      const auto count = static_cast<std::uint32_t>(p.size());
      for (int i = 0; i < 60; ++i) {
        std::array<std::uint32_t, 5> v;
        for (std::uint32_t& x : v) x = static_cast<std::uint32_t>(random() % count);
        ASSERT_EQ(signs.orientation(v[0], v[1], v[2], v[3]), to_int(orientation(p[v[0]], p[v[1]], p[v[2]], p[v[3]])));
        ASSERT_EQ(signs.in_sphere(v[0], v[1], v[2], v[3], v[4]),
                  to_int(in_sphere(p[v[0]], p[v[1]], p[v[2]], p[v[3]], p[v[4]])));
      }
    }
  }
}

}  // namespace
}  // namespace quoin
