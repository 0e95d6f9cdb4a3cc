// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/regular3.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/kernel/test_points.h"
#include "quoin/triangulation/delaunay3.h"
#include "quoin/triangulation/test_clouds.h"
#include "quoin/triangulation/test_memory.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::Matrix;
using testing::Random;

Regular3 triangulated(const std::vector<Point3>& points, const std::vector<double>& weights) {
  const Context context({.threads = 1});
  return Regular3(points, weights, context);
}

/// By its definition: positive if q, lifted by its square less its weight, is below the plane of the cell, lifted.
Sign power_by_definition(const Regular3& t, std::size_t cell, std::uint32_t q) {
  Matrix m;
  for (unsigned i = 0; i < 5; ++i) {
    const std::uint32_t v = i < 4 ? t.cells()[cell].vertices[i] : q;
    m.push_back(testing::affine_row(t.point(v), true));
    m.back()[3] -= Rational(t.weight(v));
  }
  // The sphere test is minus the determinant of the rows.
  return -testing::determinant(m).sign();
}

void expect_regular(const Regular3& t) {
  std::set<std::uint32_t> used;
  for (std::size_t c = 0; c < t.cells().size(); ++c) {
    const auto& v = t.cells()[c].vertices;
    for (unsigned i = 0; i < 4; ++i) {
      if (v[i] < t.vertex_count()) used.insert(v[i]);
      const std::uint32_t mate = t.cells()[c].neighbours[i];
      if (mate == no_vertex) continue;
      ASSERT_EQ(t.cells()[mate >> 2].neighbours[mate & 3], c * 4 + i);
    }
    if (t.dimension() < 3) continue;
    for (std::uint32_t q = 0; q < t.vertex_count(); ++q) {
      if (t.is_ghost(c)) {
        ASSERT_LE(to_int(orientation(t.point(v[0]), t.point(v[1]), t.point(v[2]), t.point(q))), 0);
        continue;
      }
      ASSERT_LE(to_int(power_by_definition(t, c, q)), 0);
    }
    if (!t.is_ghost(c)) {
      ASSERT_EQ(orientation(t.point(v[0]), t.point(v[1]), t.point(v[2]), t.point(v[3])), Sign::positive);
    }
  }
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) ASSERT_EQ(t.is_hidden(v), used.count(v) == 0);
}

TEST(Regular3, LiftedPointsAreAboveAllCells) {
  Random random(31);
  const std::array<double (*)(Random&), 4> weights{[](Random& r) { return testing::small_integer(r, 3); },
                                                   [](Random& r) { return testing::unit(r) / 4; },
                                                   [](Random& r) { return testing::any_finite(r); },
                                                   [](Random& r) { return testing::small_integer(r, 2) * 0x1p-1074; }};
  for (const Cloud& cloud : testing::clouds(random, tests_take_fewer_rounds ? 7 : 9)) {
    SCOPED_TRACE(cloud.name);
    if (cloud.points.size() > 24) continue;  // the definition is slow
    for (const auto& weight : weights) {
      std::vector<double> list;
      for (std::size_t i = 0; i < cloud.points.size(); ++i) list.push_back(weight(random));
      expect_regular(triangulated(cloud.points, list));
      ASSERT_FALSE(HasFatalFailure());
    }
  }
}

TEST(Regular3, EqualWeightsGiveDelaunay) {
  Random random(32);
  for (const Cloud& cloud : testing::clouds(random, 40)) {
    SCOPED_TRACE(cloud.name);
    const Context context({.threads = 1});
    const Delaunay3 expected(cloud.points, context);
    const Regular3 t = triangulated(cloud.points, std::vector<double>(cloud.points.size(), 0.5));
    ASSERT_EQ(t.cells().size(), expected.cells().size());
    for (std::size_t c = 0; c < t.cells().size(); ++c) {
      ASSERT_EQ(t.cells()[c].vertices, expected.cells()[c].vertices);
      ASSERT_EQ(t.cells()[c].neighbours, expected.cells()[c].neighbours);
    }
  }
}

TEST(Regular3, TheSmallestWeightsCount) {
  // Five points of a sphere, one of them lifted by less than any double that is a multiple of the grid.
  std::vector<Point3> points{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {2, 2, 2}};
  for (const double weight : {0x1p-1074, -0x1p-1074, 0x1p-1060, -0x1p-1060}) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::vector<double> weights(points.size(), 0);
      weights[i] = weight;
      expect_regular(triangulated(points, weights));
    }
  }
}

TEST(Regular3, HidesWhatIsBelowItsNeighbours) {
  const std::vector<Point3> points{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {0.5, 0.5, 0.5}};
  const auto hidden = [&](double weight) {
    const Regular3 t = triangulated(points, {0, 0, 0, 0, weight});
    int count = 0;
    for (std::uint32_t v = 0; v < t.vertex_count(); ++v) count += t.is_hidden(v) ? 1 : 0;
    return count;
  };
  // The sphere about (1, 1, 1) of square radius 3; the point is at square distance 0.75 from its centre.
  EXPECT_EQ(hidden(-2.25 + 0x1p-20), 0);
  EXPECT_EQ(hidden(-2.25 - 0x1p-20), 1);
  // Along a line.
  const Regular3 line = triangulated(testing::lattice(1, 3, 1), {0, -1.5, 0});
  EXPECT_EQ(line.cells().size(), 3U);
}

TEST(Regular3, SameCellsInAnyOrder) {
  Random random(33);
  std::vector<Point3> points = testing::lattice(4, 4, 4);
  const auto weight_of = [](const Point3& p) { return p.x == 1 && p.y == 1 ? 1.0 : p.z == 2 ? -1.0 : 0.0; };
  const auto made = [&] {
    std::vector<double> weights;
    for (const Point3& p : points) weights.push_back(weight_of(p));
    const Regular3 t = triangulated(points, weights);
    std::set<std::set<std::array<double, 3>>> cells;
    for (std::size_t c = 0; c < t.cells().size(); ++c) {
      if (t.is_ghost(c)) continue;
      std::set<std::array<double, 3>> cell;
      for (const std::uint32_t v : t.cells()[c].vertices) cell.insert({t.point(v).x, t.point(v).y, t.point(v).z});
      cells.insert(cell);
    }
    return cells;
  };
  const auto expected = made();
  for (int round = 0; round < test_rounds(10); ++round) {
    std::shuffle(points.begin(), points.end(), random);
    ASSERT_EQ(made(), expected);
  }
}

TEST(Regular3, TooLittleMemoryIsSaid) {
  const Context context({.threads = 1});
  for (const std::vector<Point3>& points :
       {testing::lattice(3, 2, 3), testing::lattice(3, 4, 1), testing::lattice(1, 4, 1)}) {
    const std::vector<double> weights(points.size(), 1);
    bool has_failed = true;
    for (std::size_t allocation = 0; has_failed; ++allocation) {
      const testing::FailingAllocation failing(allocation);
      try {
        const Regular3 t(points, weights, context);
        ASSERT_FALSE(failing.has_failed()) << allocation;
        has_failed = false;
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find("too little memory"), 0U) << error.what();
      }
    }
  }
}

TEST(Regular3, RefusesWeights) {
  const std::vector<Point3> points = testing::lattice(2, 2, 2);
  EXPECT_THROW(triangulated(points, std::vector<double>(7, 0)), InputError);
  std::vector<double> weights(8, 0);
  weights[3] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(triangulated(points, weights), InputError);
}

}  // namespace
}  // namespace quoin
