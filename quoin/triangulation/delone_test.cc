// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "quoin/base/test_rounds.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/triangulation/test_clouds.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::Random;

struct Made {
  Delaunay3 triangulation;
  DeloneComplex complex;
};

Made delone(const std::vector<Point3>& points) {
  const Context context({.threads = 1});
  Delaunay3 t(points, context);
  DeloneComplex complex(t, context);
  return {std::move(t), std::move(complex)};
}

void expect_counts(const std::vector<Point3>& points, std::size_t edges, std::size_t facets, std::size_t cells) {
  const Made made = delone(points);
  EXPECT_EQ(made.complex.edges().size(), edges);
  EXPECT_EQ(made.complex.facet_count(), facets);
  EXPECT_EQ(made.complex.cell_count(), cells);
}

/// V - E + F - C = 1, of any dimension.
void expect_euler(const DeloneComplex& complex) {
  const auto v = static_cast<std::int64_t>(complex.vertex_count());
  const auto e = static_cast<std::int64_t>(complex.edges().size());
  const auto f = static_cast<std::int64_t>(complex.facet_count());
  const auto c = static_cast<std::int64_t>(complex.cell_count());
  const int d = complex.dimension();
  EXPECT_EQ(d == 3 ? v - e + f - c : d == 2 ? v - e + c : d == 1 ? v - c : c, 1);
}

/// By coordinates, so that complexes of the same points given in other orders or moved can be compared.
std::vector<std::vector<std::array<double, 3>>> cells_by_points(const Made& made) {
  std::vector<std::vector<std::array<double, 3>>> all;
  for (std::size_t c = 0; c < made.complex.cell_count(); ++c) {
    std::vector<std::array<double, 3>> cell;
    for (const std::uint32_t v : made.complex.cell(c)) {
      const Point3 p = made.triangulation.point(v);
      cell.push_back({p.x, p.y, p.z});
    }
    std::sort(cell.begin(), cell.end());
    all.push_back(cell);
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST(Delone, KnownComplexes) {
  const std::vector<Point3> cube = testing::lattice(2, 2, 2);
  expect_counts(cube, 12, 6, 1);
  expect_counts(testing::lattice(3, 3, 3), 54, 36, 8);
  expect_counts(testing::lattice(2, 3, 4), 46, 29, 6);
  expect_counts(testing::lattice(4, 4, 1), 24, 24, 9);
  expect_counts(testing::lattice(1, 5, 1), 4, 5, 4);
  expect_counts(testing::lattice(1, 1, 1), 0, 0, 1);
  expect_counts(testing::cospherical(), 36, 14, 1);  // the truncated octahedron
  std::vector<Point3> octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  expect_counts(octahedron, 12, 8, 1);
  std::vector<Point3> cuboctahedron;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-1.0, 1.0}) {
      cuboctahedron.insert(cuboctahedron.end(), {{0, a, b}, {a, 0, b}, {a, b, 0}});
    }
  }
  expect_counts(cuboctahedron, 24, 14, 1);
  std::vector<Point3> centred = cube;
  for (Point3& p : centred) p = {2 * p.x, 2 * p.y, 2 * p.z};
  centred.push_back({1, 1, 1});
  expect_counts(centred, 20, 18, 6);  // six pyramids
}

TEST(Delone, CellsAreOnEmptySpheres) {
  Random random(11);
  for (const Cloud& cloud : testing::clouds(random, 25)) {
    SCOPED_TRACE(cloud.name);
    const Made made = delone(cloud.points);
    expect_euler(made.complex);
    if (made.complex.dimension() < 3) continue;
    const auto& t = made.triangulation;
    const DeloneLabels labels = delone_labels(t, Context({.threads = 1}));
    ASSERT_EQ(labels.cell_count, made.complex.cell_count());
    // On the sphere of any of its simplices are the vertices of the cell, and no others.
    for (std::size_t c = 0; c < t.cells().size(); ++c) {
      if (t.is_ghost(c)) continue;
      const auto& v = t.cells()[c].vertices;
      std::vector<std::uint32_t> on;
      for (std::uint32_t q = 0; q < t.vertex_count(); ++q) {
        if (in_sphere(t.point(v[0]), t.point(v[1]), t.point(v[2]), t.point(v[3]), t.point(q)) == Sign::zero) {
          on.push_back(q);
        }
      }
      bool is_found = false;
      for (std::size_t k = 0; k < made.complex.cell_count(); ++k) {
        const auto cell = made.complex.cell(k);
        is_found = is_found || std::equal(cell.begin(), cell.end(), on.begin(), on.end());
      }
      ASSERT_TRUE(is_found);
    }
  }
}

TEST(Delone, FacetsAreFlatAndSeenFromOutside) {
  Random random(12);
  for (const Cloud& cloud : testing::clouds(random, 30)) {
    SCOPED_TRACE(cloud.name);
    const Made made = delone(cloud.points);
    if (made.complex.dimension() < 3) continue;
    const auto& t = made.triangulation;
    for (std::size_t f = 0; f < made.complex.facet_count(); ++f) {
      const auto polygon = made.complex.facet(f);
      ASSERT_GE(polygon.size(), 3U);
      ASSERT_EQ(*std::min_element(polygon.begin(), polygon.end()), polygon[0]);
      const std::array<Point3, 3> p{t.point(polygon[0]), t.point(polygon[1]), t.point(polygon[2])};
      const auto [inner, outer] = made.complex.cells_of_facet(f);
      for (const std::uint32_t v : made.complex.cell(inner)) {
        const bool is_corner = std::find(polygon.begin(), polygon.end(), v) != polygon.end();
        ASSERT_EQ(orientation(p[0], p[1], p[2], t.point(v)), is_corner ? Sign::zero : Sign::negative);
      }
      if (outer == DeloneComplex::outside) continue;
      ASSERT_LT(inner, outer);
      for (const std::uint32_t v : made.complex.cell(outer)) {
        const bool is_corner = std::find(polygon.begin(), polygon.end(), v) != polygon.end();
        ASSERT_EQ(orientation(p[0], p[1], p[2], t.point(v)), is_corner ? Sign::zero : Sign::positive);
      }
    }
  }
}

TEST(Delone, AllPermutationsOfSmallInputs) {
  Random random(13);
  for (int round = 0; round < test_rounds(10); ++round) {
    std::vector<Point3> points =
        testing::random_points(random, 6, [](Random& r) { return testing::small_integer(r, 1); });
    const auto expected = cells_by_points(delone(points));
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    do {
      std::vector<Point3> moved;
      for (const int i : order) moved.push_back(points[static_cast<std::size_t>(i)]);
      ASSERT_EQ(cells_by_points(delone(moved)), expected);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

/// The ties in the triangulation are broken in other ways, and the complex stays.
TEST(Delone, AxesMayBePermutedAndReflected) {
  Random random(14);
  for (const Cloud& cloud : testing::clouds(random, 40)) {
    SCOPED_TRACE(cloud.name);
    const Made made = delone(cloud.points);
    const auto moved = [&](auto move) {
      std::vector<Point3> points;
      for (const Point3& p : cloud.points) points.push_back(move(p));
      return delone(points);
    };
    auto turned = cells_by_points(moved([](const Point3& p) { return Point3{-p.z, p.x, p.y}; }));
    for (auto& cell : turned) {
      for (auto& [x, y, z] : cell) {
        const double old_z = x == 0 ? 0.0 : -x;
        x = y;
        y = z;
        z = old_z;
      }
      std::sort(cell.begin(), cell.end());
    }
    std::sort(turned.begin(), turned.end());
    EXPECT_EQ(turned, cells_by_points(made));
  }
}

TEST(DeloneCounts, AreThoseOfTheComplex) {
  Random random(12);
  const Context context({.threads = 1});
  for (const std::size_t size : {1, 2, 4, 9, 70}) {
    for (const Cloud& cloud : testing::clouds(random, size)) {
      SCOPED_TRACE(cloud.name);
      const Delaunay3 t(cloud.points, context);
      const DeloneComplex complex(t, context);
      const std::array<std::size_t, 4> faces = count_faces(t, delone_labels(t, context), context).faces;
      EXPECT_EQ(faces[0], t.vertex_count());
      EXPECT_EQ(faces[1], complex.edges().size());
      if (t.dimension() == 3) {
        EXPECT_EQ(faces[2], complex.facet_count());
      }
      EXPECT_EQ(faces[static_cast<std::size_t>(t.dimension())], complex.cell_count());
    }
  }
}

}  // namespace
}  // namespace quoin
