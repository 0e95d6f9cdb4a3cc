// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_delaunay3.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/triangulation/delaunay_location.h"
#include "quoin/triangulation/test_changing3.h"
#include "quoin/triangulation/test_clouds.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::Corner;
using testing::corners_of;
using testing::expect_same;
using testing::Present;
using testing::Random;
using testing::reproduce;

const Context context({.threads = 1});

TEST(ChangingDelaunay3, IsDelaunayAfterEachChange) {
  Random random(1);
  for (int round = 0; round < test_rounds(2); ++round) {
    for (const Cloud& cloud : testing::clouds(random, 16)) {
      ChangingDelaunay3 changing;
      Present present;
      for (int step = 0; step < 50; ++step) {
        SCOPED_TRACE(cloud.name + ": " + reproduce(present.points));
        // Grows for a while, and falls to nothing.
        if (present.points.empty() || random() % 50 > static_cast<unsigned>(step)) {
          const Point3 p = cloud.points[random() % cloud.points.size()];
          SCOPED_TRACE("insert " + reproduce({p}));
          present.add(p, changing.insert(p));
          ASSERT_EQ(changing.point(present.vertices.back()), p);
        } else {
          const std::size_t which = random() % present.points.size();
          SCOPED_TRACE("remove " + reproduce({present.points[which]}));
          changing.remove(present.vertices[which]);
          present.erase(which);
        }
        expect_same(changing, present.points);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(ChangingDelaunay3, HalfOfManyPoints) {
  Random random(2);
  for (const Cloud& cloud : testing::clouds(random, test_rounds(30U))) {
    SCOPED_TRACE(cloud.name);
    const std::vector<Point3>& points = cloud.points;
    ChangingDelaunay3 changing(points, context);
    expect_same(changing, points);
    const Delaunay3 delaunay(points, context);
    std::vector<std::uint32_t> vertices(points.size());
    for (std::uint32_t v = 0; v < delaunay.vertex_count(); ++v) {
      ASSERT_EQ(changing.point(v), delaunay.point(v));
      for (const std::uint32_t i : delaunay.inputs(v)) vertices[i] = v;
    }
    const std::size_t kept = points.size() / 2;
    for (std::size_t i = kept; i < points.size(); ++i) changing.remove(vertices[i]);
    expect_same(changing, {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(kept)});
    // In again, and all is as it was.
    for (std::size_t i = kept; i < points.size(); ++i) vertices[i] = changing.insert(points[i]);
    expect_same(changing, points);
    // Down to nothing, and up again.
    for (std::size_t i = 0; i < points.size(); ++i) changing.remove(vertices[i]);
    expect_same(changing, {});
    for (std::size_t i = 0; i < kept; ++i) changing.insert(points[i]);
    expect_same(changing, {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(kept)});
    ASSERT_LE(changing.id_count(), points.size() + 1);
    if (HasFatalFailure()) return;
  }
}

TEST(ChangingDelaunay3, HalfOfLargeClouds) {
  Random random(10);
  const auto on_grid = [](Random& r) { return testing::small_integer(r, 9); };
  std::vector<Cloud> all{{"uniform", testing::random_points(random, test_rounds(2000U), testing::unit)},
                         {"sphere", testing::near_sphere(random, test_rounds(1000U))},
                         {"lattice", testing::lattice(9, 10, 11)},
                         {"plane", testing::lattice(30, 30, 1)},
                         {"grid", testing::random_points(random, test_rounds(2000U), on_grid)}};
  for (Cloud& cloud : all) {
    SCOPED_TRACE(cloud.name);
    std::ranges::shuffle(cloud.points, random);
    std::vector<Point3>& points = cloud.points;
    ChangingDelaunay3 changing;
    std::vector<std::uint32_t> vertices;
    for (const Point3& p : points) vertices.push_back(changing.insert(p));
    expect_same(changing, points);
    while (vertices.size() > points.size() / 2) {
      changing.remove(vertices.back());
      vertices.pop_back();
    }
    points.resize(vertices.size());
    expect_same(changing, points);
    if (HasFatalFailure()) return;
  }
}

/// Each way to put few points in, and each way to take them out again.
TEST(ChangingDelaunay3, EachOrderOfFewPoints) {
  const std::vector<std::vector<Point3>> sets{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},  // of one sphere
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {0, 0, 1}},     // a pyramid with two points at its tip
      {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {0, 1, 0}, {1, 0, 0}},     // most of a line
      {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 0}, {1, 1, 1}, {1, 1, -1}},    // of a plane, and one on either side
      {{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}, {0, 0, 1e300}, {1e-300, 1e-300, 1e-300}, {1, 1, 1}}};
  for (const std::vector<Point3>& points : sets) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Which points are there, as bits, says what cells are.
    std::vector<std::vector<std::array<Corner, 4>>> known(std::size_t{1} << points.size());
    std::size_t orders = 0;
    do {
      if (tests_take_fewer_rounds && ++orders % 10 != 0) continue;
      ChangingDelaunay3 changing;
      std::vector<std::uint32_t> vertices(points.size());
      std::size_t there = 0;
      const auto expect_known = [&] {
        const CellArray flat = changing.flat_cells();
        const auto cells = corners_of(flat.empty() ? changing.cells() : flat,
                                      [&changing](std::uint32_t v) { return changing.point(v); });
        if (known[there].empty() && there != 0) {
          std::vector<Point3> present;
          for (std::size_t i = 0; i < points.size(); ++i) {
            if ((there >> i & 1) != 0) present.push_back(points[i]);
          }
          expect_same(changing, present);
          known[there] = cells;
        }
        ASSERT_EQ(known[there], cells) << there;
      };
      for (const std::size_t i : order) {
        vertices[i] = changing.insert(points[i]);
        there |= std::size_t{1} << i;
        expect_known();
      }
      for (const std::size_t i : order) {
        changing.remove(vertices[i]);
        there &= ~(std::size_t{1} << i);
        expect_known();
      }
      if (HasFatalFailure()) return;
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

/// The bounds that filters stand on, and the power of two that points are kept times, change on the way.
TEST(ChangingDelaunay3, PointsOfAllSizes) {
  Random random(3);
  for (int round = 0; round < test_rounds(6); ++round) {
    ChangingDelaunay3 changing;
    Present present;
    for (int step = 0; step < 60; ++step) {
      SCOPED_TRACE(reproduce(present.points));
      if (step % 30 < 15) {
        constexpr std::array<int, 8> sizes{-1074, -1000, -700, -60, 0, 60, 700, 1017};
        // Mostly of one size for a while: often all can be scaled, now and then not.
        const int size = sizes[random() % 5 == 0 ? random() % sizes.size() : static_cast<std::size_t>(step / 6) % 8];
        Point3 p;
        for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = std::ldexp(testing::small_integer(random, 9), size);
        present.add(p, changing.insert(p));
      } else {
        const std::size_t which = random() % present.points.size();
        changing.remove(present.vertices[which]);
        present.erase(which);
      }
      for (std::size_t i = 0; i < present.points.size(); ++i) {
        ASSERT_EQ(changing.point(present.vertices[i]), present.points[i]);
      }
      expect_same(changing, present.points);
      if (HasFatalFailure()) return;
    }
  }
}

/// Stars of more vertices than tables hold, on the hull, too.
TEST(ChangingDelaunay3, LargeStars) {
  Random random(4);
  std::vector<Point3> points = testing::near_sphere(random, 300);
  for (std::size_t i = 0; i < 150; ++i) points.push_back({points[i].x / 64 + 4, points[i].y / 2, 0});
  ChangingDelaunay3 changing(points, context);
  const std::vector<Point3> others{{0, 0, 0}, {1e-3, 2e-3, -1e-3}, {1e6, 0, 0}, {4, 0, 0.125}, {4, 0, -0.125}};
  Present present;
  for (const Point3& p : others) present.add(p, changing.insert(p));
  EXPECT_GT(changing.neighbours(present.vertices[2]).size(), 64U);
  points.insert(points.end(), others.begin(), others.end());
  expect_same(changing, points);
  for (const std::uint32_t v : present.vertices) {
    points.erase(std::ranges::find(points, changing.point(v)));
    changing.remove(v);
    expect_same(changing, points);
  }
}

TEST(ChangingDelaunay3, StarsAndNeighboursAreThoseOfTheCells) {
  Random random(5);
  for (const Cloud& cloud : testing::clouds(random, 30)) {
    SCOPED_TRACE(cloud.name);
    const ChangingDelaunay3 changing(cloud.points, context);
    if (changing.dimension() < 3) continue;
    for (std::uint32_t v = 0; v < changing.id_count(); ++v) {
      std::vector<std::uint32_t> star;
      std::vector<std::uint32_t> neighbours;
      for (std::uint32_t c = 0; c < changing.cells().size(); ++c) {
        const auto& corners = changing.cells()[c].vertices;
        if (std::ranges::find(corners, v) == corners.end()) continue;
        star.push_back(c);
        for (const std::uint32_t w : corners) {
          if (w != v && w != vertex_at_infinity) neighbours.push_back(w);
        }
      }
      std::ranges::sort(neighbours);
      neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
      std::vector<std::uint32_t> found = changing.star(v);
      std::ranges::sort(found);
      EXPECT_EQ(found, star);
      EXPECT_EQ(changing.neighbours(v), neighbours);
    }
  }
}

/// Some places to look for, of which many are vertices or in the middle of two.
std::vector<Point3> places(Random& random, const std::vector<Point3>& points) {
  std::vector<Point3> list;
  for (int i = 0; i < 12; ++i) {
    const Point3& p = points[random() % points.size()];
    const Point3& q = points[random() % points.size()];
    list.push_back({p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2});
  }
  return list;
}

/// Points of a face of a triangulation below dimension 3, ascending.
template <class At>
std::vector<Point3> face_points(const TriangulationCell& cell, const DelaunayLocation& found, const At& at) {
  std::vector<Point3> points;
  for (unsigned i = 0; i < 4; ++i) {
    if ((found.slots >> i & 1) != 0) points.push_back(at(cell.vertices[i]));
  }
  std::sort(points.begin(), points.end(),
            [](const Point3& a, const Point3& b) { return lexicographically_less(a, b); });
  return points;
}

/// Below dimension 3, of a point that is in the hull, outside, or off the plane or line.
void expect_found_as_without_changes(const ChangingDelaunay3& changing, const Point3& p) {
  std::vector<Point3> rest;
  for (std::uint32_t v = 0; v < changing.id_count(); ++v) {
    if (changing.lives(v)) rest.push_back(changing.point(v));
  }
  const Delaunay3 t(rest, context);
  const DelaunayLocation expected = DelaunayLocator(t).locate(p);
  const DelaunayLocation found = changing.locate(p);
  ASSERT_EQ(found.kind, expected.kind);
  const CellArray flat = changing.flat_cells();
  if (found.kind == DelaunayLocation::Kind::outside_affine_hull) return;
  if (found.kind == DelaunayLocation::Kind::outside) {
    EXPECT_EQ(flat[found.cell].vertices[static_cast<std::size_t>(changing.dimension())], vertex_at_infinity);
    return;
  }
  const auto points = face_points(flat[found.cell], found, [&](std::uint32_t v) { return changing.point(v); });
  if (found.kind != DelaunayLocation::Kind::facet) {
    EXPECT_EQ(points, face_points(t.cells()[expected.cell], expected, [&](std::uint32_t v) { return t.point(v); }));
  }
  // Of triangles there may be another diagonal: the point is inside, seen along any axis.
  for (std::size_t axis = 0; points.size() == 3 && axis < 3; ++axis) {
    const auto along = [axis](const Point3& q) { return Point2{q[(axis + 1) % 3], q[(axis + 2) % 3]}; };
    const Sign turn = orientation(along(points[0]), along(points[1]), along(points[2]));
    for (unsigned i = 0; i < 3; ++i)
      EXPECT_EQ(orientation(along(points[i]), along(points[(i + 1) % 3]), along(p)), turn);
  }
}

TEST(ChangingDelaunay3, FindsPlacesAndNearestVertices) {
  Random random(11);
  for (const Cloud& cloud : testing::clouds(random, 24)) {
    SCOPED_TRACE(cloud.name);
    ChangingDelaunay3 changing(cloud.points, context);
    // Holes among the ids.
    for (std::uint32_t v = 0; v < changing.id_count(); v += 3) {
      if (changing.vertex_count() > 1 && changing.lives(v)) changing.remove(v);
    }
    for (const Point3& p : places(random, cloud.points)) {
      std::uint32_t nearest = no_vertex;
      for (std::uint32_t v = 0; v < changing.id_count(); ++v) {
        if (!changing.lives(v)) continue;
        if (nearest == no_vertex || compare_distances(p, changing.point(v), changing.point(nearest)) < 0) nearest = v;
      }
      EXPECT_EQ(changing.nearest(p), nearest);
      if (changing.dimension() < 3) {
        expect_found_as_without_changes(changing, p);
        expect_found_as_without_changes(changing, {p.x + 1, p.y / 2, p.z - 0.25});
        continue;
      }
      const DelaunayLocation found = changing.locate(p);
      const auto& v = changing.cells()[found.cell].vertices;
      ASSERT_EQ(v[3] == vertex_at_infinity, found.kind == DelaunayLocation::Kind::outside);
      for (unsigned i = 0; i < 4; ++i) {
        const auto& [a, b, c] = facet_slots[i];
        if (v[3] == vertex_at_infinity && i != 3) continue;
        const Sign side = orientation(changing.point(v[a]), changing.point(v[b]), changing.point(v[c]), p);
        // A ghost's facet sees it; of a cell, those slots that are not of the face have it in their facets.
        const bool is_off = v[3] == vertex_at_infinity || (found.slots >> i & 1) != 0;
        EXPECT_EQ(side, is_off ? Sign::positive : Sign::zero);
      }
    }
  }
}

TEST(ChangingDelaunay3, CopiesChangeAlone) {
  Random random(6);
  const std::vector<Point3> points = testing::random_points(random, 60, testing::unit);
  ChangingDelaunay3 changing(points, context);
  ChangingDelaunay3 copy = changing;
  for (std::uint32_t v = 0; v < 30; ++v) copy.remove(v);
  expect_same(changing, points);
  changing = copy;
  ChangingDelaunay3 moved = std::move(copy);
  moved.insert({0, 0, 0});
  std::vector<Point3> rest;
  for (std::uint32_t v = 30; v < 60; ++v) rest.push_back(changing.point(v));
  expect_same(changing, rest);
  rest.push_back({0, 0, 0});
  expect_same(moved, rest);
}

}  // namespace
}  // namespace quoin
