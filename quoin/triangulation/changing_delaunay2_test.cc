// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_delaunay2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <new>
#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/triangulation/test_memory.h"
#include "quoin/triangulation/test_points2.h"

namespace quoin {
namespace {

using testing::point_sets;
using testing::Random;

using Corners = std::array<std::pair<double, double>, 3>;

// Infinite triangles too, by a place of their own.
template <class Place>
std::set<Corners> corners_of(std::span<const TriangleLinks2> triangles, const Place& place) {
  std::set<Corners> found;
  for (const TriangleLinks2& t : triangles) {
    Corners corners;
    for (unsigned slot = 0; slot < 3; ++slot) corners[slot] = place(t.corner[slot]);
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    EXPECT_TRUE(found.insert(corners).second);
  }
  return found;
}

// Linked as a sphere is, and the same triangles as of the points that are there.
void expect_same(const ChangingDelaunay2& changing, const std::vector<Point2>& points) {
  const Delaunay2 delaunay(points);
  constexpr double beyond = std::numeric_limits<double>::infinity();
  ASSERT_EQ(changing.dimension(), delaunay.dimension());
  ASSERT_EQ(changing.vertex_count(), delaunay.vertex_count());
  ASSERT_EQ(changing.line().size(), delaunay.line().size());
  for (std::size_t i = 0; i < delaunay.line().size(); ++i) {
    EXPECT_EQ(changing.point(changing.line()[i]), delaunay.point(delaunay.line()[i]));
  }
  const auto triangles = changing.triangles();
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (unsigned slot = 0; slot < 3; ++slot) {
      const Edge2 other(triangles[t].across[slot]);
      ASSERT_LT(other.triangle().index(), triangles.size());
      const TriangleLinks2& neighbour = triangles[other.triangle().index()];
      ASSERT_EQ(neighbour.across[other.slot()], 4 * t + slot);
      ASSERT_EQ(neighbour.corner[next_slot(other.slot())], triangles[t].corner[previous_slot(slot)]);
      ASSERT_EQ(neighbour.corner[previous_slot(other.slot())], triangles[t].corner[next_slot(slot)]);
    }
  }
  ASSERT_EQ(corners_of(triangles,
                       [&](std::uint32_t v) {
                         const Point2& p = changing.point(Vertex2(std::size_t{v}));
                         return v == 0 ? std::pair(beyond, beyond) : std::pair(p.x, p.y);
                       }),
            corners_of(delaunay.links().links(), [&](std::uint32_t v) {
              const Point2& p = delaunay.points()[v];
              return v == delaunay.vertex_count() ? std::pair(beyond, beyond) : std::pair(p.x, p.y);
            }));
  std::size_t living = 0;
  std::size_t given = 0;
  for (std::size_t v = 1; v < changing.id_count(); ++v) {
    if (!changing.lives(Vertex2(v))) continue;
    ++living;
    given += changing.multiplicity(Vertex2(v));
    if (changing.dimension() < 2) continue;
    const Edge2 e = changing.edge_from(Vertex2(v));
    EXPECT_EQ(triangles[e.triangle().index()].corner[next_slot(e.slot())], v);
  }
  EXPECT_EQ(living, delaunay.vertex_count());
  EXPECT_EQ(given, points.size());
}

TEST(ChangingDelaunay2, IsDelaunayAfterEachChange) {
  Random random(1);
  for (const auto& family : point_sets()) {
    for (int round = 0; round < test_rounds(4); ++round) {
      const std::vector<Point2> pool = family.make(random, 14);
      std::vector<Point2> points;
      ChangingDelaunay2 changing;
      std::vector<Vertex2> vertices;
      for (int step = 0; step < 40; ++step) {
        SCOPED_TRACE(std::string(family.name) + ": " + testing::reproduce(points));
        // Grows for a while, and falls to nothing.
        if (points.empty() || random() % 40 > static_cast<unsigned>(step)) {
          points.push_back(pool[random() % pool.size()]);
          vertices.push_back(changing.insert(points.back()));
        } else {
          const std::size_t which = random() % points.size();
          SCOPED_TRACE(testing::reproduce(std::vector<Point2>{points[which]}));
          changing.remove(vertices[which]);
          points.erase(points.begin() + static_cast<std::ptrdiff_t>(which));
          vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(which));
        }
        expect_same(changing, points);
        if (::testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

TEST(ChangingDelaunay2, HalfOfManyPoints) {
  Random random(2);
  for (const auto& family : point_sets()) {
    std::vector<Point2> points = family.make(random, test_rounds(400));
    const std::size_t kept = points.size() / 2;
    SCOPED_TRACE(family.name);
    ChangingDelaunay2 changing(points);
    expect_same(changing, points);
    const std::vector<Vertex2> vertices = Delaunay2(points).vertices_of_inputs();
    for (std::size_t i = kept; i < points.size(); ++i) changing.remove(Vertex2(vertices[i].index() + 1));
    const std::vector<Point2> half(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(kept));
    expect_same(changing, half);
    // In again, and all is as it was.
    for (std::size_t i = kept; i < points.size(); ++i) changing.insert(points[i]);
    expect_same(changing, points);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

// Makes each allocation of the change fail, one after the other, until it comes to its end.
template <class Change>
void change_with_failures(const ChangingDelaunay2& changing, const std::vector<Point2>& before, const Change& change) {
  for (std::size_t allocation = 0;; ++allocation) {
    SCOPED_TRACE("allocation " + std::to_string(allocation));
    try {
      const testing::FailingAllocation failing(allocation);
      change();
      return;
    } catch (const std::bad_alloc&) {
    }
    expect_same(changing, before);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(ChangingDelaunay2, IsAsItWasWhereMemoryFails) {
  Random random(3);
  for (const auto& family : point_sets()) {
    const std::vector<Point2> pool = family.make(random, 12);
    std::vector<Point2> points;
    ChangingDelaunay2 changing;
    std::vector<Vertex2> vertices;
    for (int step = 0; step < 24; ++step) {
      SCOPED_TRACE(std::string(family.name) + ": " + testing::reproduce(points));
      if (points.empty() || random() % 24 > static_cast<unsigned>(step)) {
        const Point2 p = pool[random() % pool.size()];
        Vertex2 v;
        change_with_failures(changing, points, [&] { v = changing.insert(p); });
        points.push_back(p);
        vertices.push_back(v);
      } else {
        const std::size_t which = random() % points.size();
        change_with_failures(changing, points, [&] { changing.remove(vertices[which]); });
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(which));
        vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(which));
      }
      expect_same(changing, points);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(ChangingDelaunay2, LongChangesAreCancelledAndChangeNothing) {
  Context cancelled({.threads = 1});
  cancelled.cancel();
  std::vector<Point2> points;
  for (int i = 0; i < 600; ++i) points.push_back({static_cast<double>(i), 2.0 * i});
  ChangingDelaunay2 changing(points);
  const Point2 apex{300, 0};
  const Point2 inner{299, 580};
  EXPECT_THROW(changing.insert(apex, cancelled), Cancelled);
  expect_same(changing, points);
  // The line is left, and one more point inserted.
  const Vertex2 a = changing.insert(apex);
  points.push_back(apex);
  EXPECT_THROW(changing.insert(inner, cancelled), Cancelled);
  expect_same(changing, points);
  const Vertex2 b = changing.insert(inner);
  points.push_back(inner);
  expect_same(changing, points);
  // A star of many triangles, then one whose removal leaves a line.
  EXPECT_THROW(changing.remove(b, cancelled), Cancelled);
  expect_same(changing, points);
  changing.remove(b);
  points.pop_back();
  EXPECT_THROW(changing.remove(a, cancelled), Cancelled);
  expect_same(changing, points);
  changing.remove(a);
  points.pop_back();
  expect_same(changing, points);
}

TEST(ChangingDelaunay2, BadInputIsRefused) {
  ChangingDelaunay2 changing;
  EXPECT_THROW(changing.insert({0, std::numeric_limits<double>::infinity()}), InputError);
  EXPECT_THROW(changing.remove(Vertex2(0)), InputError);
  EXPECT_THROW(changing.remove(Vertex2(1)), InputError);
  const Vertex2 v = changing.insert({1, 2});
  EXPECT_EQ(changing.insert({1, 2}), v);
  changing.remove(v);
  changing.remove(v);
  EXPECT_THROW(changing.remove(v), InputError);
  EXPECT_EQ(changing.dimension(), -1);
}

}  // namespace
}  // namespace quoin
