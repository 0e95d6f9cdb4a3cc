// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/critical_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "quoin/flow/critical_spheres.h"
#include "quoin/triangulation/test_clouds.h"

namespace quoin {
namespace {

using testing::Random;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

/// Within 2^-30 of the largest coordinate of the point or of the corners.
void check_near(const Point3& near, const RationalPoint3& exact, double corners) {
  const RationalPoint3 off = exact - exact_point(near);
  const Rational most = std::max({Rational(corners), abs(exact.x), abs(exact.y), abs(exact.z)});
  for (unsigned axis = 0; axis < 3; ++axis) ASSERT_LE(abs(off[axis]), most * Rational(0x1p-30));
}

/// Of all faces, critical or not.
TEST(CriticalSpheres, AreTheValuesOfTheirFaces) {
  Random random(106);
  std::size_t compared = 0;
  for (const double scale : {1.0, 0x1p700, 0x1p-700}) {
    for (const double flatness : {1.0, 0x1p-60}) {
      for (const bool is_grid : {false, true}) {
        std::vector<Point3> points = testing::near_sphere(random, 30);
        for (Point3& p : points) {
          if (is_grid) p = {std::round(8 * p.x), std::round(8 * p.y), std::round(8 * p.z)};
          p = {(p.x + 3) * scale, p.y * scale, p.z * flatness * scale};
        }
        const Delaunay3 triangulation(points, context());
        if (triangulation.dimension() < 3) continue;
        const FlowCells cells(triangulation, context());
        const CriticalValues values(triangulation);
        const CriticalSpheres spheres(triangulation);
        const auto compare = [&](const CriticalFace& face, const Rational& square) {
          const Interval close = spheres.close_square(face);
          ASSERT_EQ(spheres.exact_square(face).rational(), square);
          ASSERT_TRUE(Rational(close.lower()) <= square);
          ASSERT_TRUE(std::isinf(close.upper()) || square <= Rational(close.upper()));
          if (std::isfinite(close.upper()) && close.lower() > 0x1p-1000) {
            ASSERT_LE(close.upper() - close.lower(), 0x1p-49 * close.upper());
          }
          ++compared;
        };
        for (std::uint32_t c = 0; c < cells.cells().size(); ++c) {
          if (cells.is_ghost(c)) continue;
          compare(CriticalFace::simplex(cells, c), values.exactly_of_cell(c));
          for (unsigned slot = 0; slot < 4; ++slot) {
            const CellFacet facet{c, slot};
            compare(CriticalFace::facet(cells, facet), values.exactly_of_facet(facet));
          }
          for (unsigned edge = 0; edge < 6; ++edge)
            compare(CriticalFace::edge(cells, c, edge), values.exactly_of_edge(c, edge));
        }
      }
    }
  }
  EXPECT_GT(compared, 5000U);
}

TEST(CriticalValues, NearCentresAreNear) {
  Random random(104);
  std::size_t compared = 0;
  for (double scale : {1.0, 0x1p700, 0x1p-700}) {
    for (double flatness : {1.0, 0x1p-30, 0x1p-60}) {
      std::vector<Point3> points = testing::near_sphere(random, 30);
      for (Point3& p : points) p = {(p.x + 3) * scale, p.y * scale, p.z * flatness * scale};
      const Delaunay3 triangulation(points, context());
      if (triangulation.dimension() < 3) continue;
      const FlowCells cells(triangulation, context());
      const CriticalValues values(triangulation);
      const auto largest = [&](std::uint32_t cell) {
        double most = 0;
        for (const std::uint32_t v : cells.cells()[cell].vertices) {
          const Point3 p = triangulation.point(v);
          most = std::max({most, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
        }
        return most;
      };
      for (std::uint32_t c = 0; c < cells.cells().size(); ++c) {
        if (cells.is_ghost(c)) continue;
        check_near(values.near_centre(c), values.centre(c), largest(c));
        for (unsigned slot = 0; slot < 4; ++slot)
          check_near(values.near_centre(CellFacet{c, slot}), values.centre(CellFacet{c, slot}), largest(c));
        for (unsigned edge = 0; edge < 6; ++edge)
          check_near(values.near_midpoint(c, edge), values.midpoint(c, edge), largest(c));
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 300U);
}

}  // namespace
}  // namespace quoin
