// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_regular3.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/triangulation/changing_delaunay3.h"
#include "quoin/triangulation/test_changing_regular3.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::expect_same;
using testing::Random;
using testing::reproduce;
using testing::SiteWeightFamily;
using Present = testing::PresentSites<WeightedPoint3>;

const Context context({.threads = 1});

ChangingRegular3 triangulated(const std::vector<WeightedPoint3>& sites) {
  return ChangingRegular3(testing::points_of(sites), testing::weights_of(sites), context);
}

TEST(ChangingRegular3, IsRegularAfterEachChange) {
  Random random(1);
  for (int round = 0; round < test_rounds(2); ++round) {
    for (const SiteWeightFamily& family : testing::site_weight_families()) {
      for (const Cloud& cloud : testing::clouds(random, 14)) {
        ChangingRegular3 changing;
        Present present;
        for (int step = 0; step < 40; ++step) {
          SCOPED_TRACE(cloud.name + ", " + family.name + ": " + reproduce(present.points));
          // Grows for a while, and falls to nothing.
          if (present.points.empty() || random() % 40 > static_cast<unsigned>(step)) {
            const WeightedPoint3 site{cloud.points[random() % cloud.points.size()], family.weight(random)};
            SCOPED_TRACE("insert " + reproduce({site}));
            present.add(site, changing.insert(site.point, site.weight));
            ASSERT_EQ(changing.point(present.vertices.back()), site.point);
            ASSERT_EQ(changing.weight(present.vertices.back()), site.weight);
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
}

TEST(ChangingRegular3, HalfOfManyPoints) {
  Random random(2);
  for (const SiteWeightFamily& family : testing::site_weight_families()) {
    for (const Cloud& cloud : testing::clouds(random, test_rounds(16U))) {
      SCOPED_TRACE(cloud.name + ", " + family.name);
      std::vector<WeightedPoint3> sites = testing::weighted(cloud.points, family, random);
      ChangingRegular3 changing = triangulated(sites);
      expect_same(changing, sites);
      // The heaviest of equal points have the numbers of Regular3.
      const Regular3 regular(testing::points_of(sites), testing::weights_of(sites), context);
      for (std::uint32_t v = 0; v < regular.vertex_count(); ++v) {
        ASSERT_EQ(changing.point(v), regular.point(v));
        ASSERT_EQ(changing.weight(v), regular.weight(v));
      }
      const std::vector<WeightedPoint3> kept(sites.begin(),
                                             sites.begin() + static_cast<std::ptrdiff_t>(sites.size() / 2));
      std::vector<std::uint32_t> vertices;
      for (const auto& [p, weight] : sites) {
        vertices.push_back(changing.insert(p, weight));
        changing.remove(vertices.back());
      }
      expect_same(changing, sites);
      for (std::size_t i = kept.size(); i < sites.size(); ++i) changing.remove(vertices[i]);
      expect_same(changing, kept);
      // In again, and all is as it was.
      for (std::size_t i = kept.size(); i < sites.size(); ++i) {
        vertices[i] = changing.insert(sites[i].point, sites[i].weight);
      }
      expect_same(changing, sites);
      for (const std::uint32_t v : vertices) changing.remove(v);
      expect_same(changing, {});
      for (const auto& [p, weight] : kept) changing.insert(p, weight);
      expect_same(changing, kept);
      ASSERT_LE(changing.id_count(), sites.size() + 1);
      if (HasFatalFailure()) return;
    }
  }
}

/// From a few hidden points to many.
TEST(ChangingRegular3, HalfOfLargeClouds) {
  Random random(3);
  const auto on_grid = [](Random& r) { return testing::small_integer(r, 9); };
  const std::vector<Cloud> all{{"uniform", testing::random_points(random, test_rounds(2000U), testing::unit)},
                               {"sphere", testing::near_sphere(random, test_rounds(600U))},
                               {"lattice", testing::lattice(9, 10, 11)},
                               {"plane", testing::lattice(30, 30, 1)},
                               {"grid", testing::random_points(random, test_rounds(2000U), on_grid)}};
  for (const double largest : {0.001, 0.03, 4.0}) {
    for (const Cloud& cloud : all) {
      SCOPED_TRACE(cloud.name);
      std::vector<WeightedPoint3> sites;
      for (const Point3& p : cloud.points) sites.push_back({p, testing::unit(random) * largest});
      std::ranges::shuffle(sites, random);
      ChangingRegular3 changing;
      std::vector<std::uint32_t> vertices;
      for (const auto& [p, weight] : sites) vertices.push_back(changing.insert(p, weight));
      expect_same(changing, sites);
      while (vertices.size() > sites.size() / 2) {
        changing.remove(vertices.back());
        vertices.pop_back();
      }
      sites.resize(vertices.size());
      expect_same(changing, sites);
      if (HasFatalFailure()) return;
    }
  }
}

/// Each way to put few points in, and each way to take them out again.
TEST(ChangingRegular3, EachOrderOfFewPoints) {
  const std::vector<std::vector<WeightedPoint3>> sets{
      // A cell, a point that it hides, one that hides this when the cell has gone, and one that hides a corner.
      {{{0, 0, 0}, 0}, {{2, 0, 0}, 0}, {{0, 2, 0}, 0}, {{0, 0, 2}, 0}, {{.5, .5, .5}, -2.5}, {{0.25, 0, 0}, 1}},
      // Equal points of many weights, off a plane or not.
      {{{0, 0, 0}, 0}, {{2, 0, 0}, 0}, {{0, 2, 0}, 0}, {{1, 1, 1}, 0}, {{1, 1, 1}, 1}, {{1, 1, 1}, -1}},
      {{{0, 0, 0}, 0}, {{2, 0, 0}, 0}, {{0, 2, 0}, 0}, {{0, 0, 0}, 1}, {{0, 0, 0}, 2}, {{2, 2, 0}, 1}},
      // Two of them are the first ones of an upright plane.
      {{{0, 0, 0}, 0}, {{0, 0, 0}, 1}, {{0, 2, 0}, 0}, {{0, 0, 2}, 0}, {{0, 2, 3}, 1}, {{1, 1, 1}, 0}},
      // Of a sphere, on the lower hull or above it.
      {{{1, 0, 0}, 0}, {{-1, 0, 0}, 0}, {{0, 1, 0}, 0}, {{0, -1, 0}, 0}, {{0, 0, 1}, 1}, {{0, 0, 0}, -1}},
      // Of a line, whose middle is on the chain or above it, and two points off it.
      {{{0, 0, 0}, 0}, {{1, 1, 1}, -3}, {{2, 2, 2}, 0}, {{3, 3, 3}, -0.5}, {{1, 0, 0}, 0}, {{1, 0, 1}, 6}},
      // Of a plane: what one corner hides.
      {{{0, 0, 0}, 0}, {{3, 0, 0}, 8}, {{0, 3, 0}, 0}, {{1, 1, 0}, 0}, {{2, 0, 0}, 0}, {{1, 1, -1}, 4}},
      {{{0, 0, 0}, 1e300},
       {{1e300, 0, 0}, 0},
       {{0, 1e300, 0}, 1},
       {{0, 0, 1e300}, 1e-300},
       {{1, 1, 1}, 1e300},
       {{1e-300, 0, 0}, 1}}};
  for (const std::vector<WeightedPoint3>& sites : sets) {
    std::vector<std::size_t> order(sites.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::size_t orders = 0;
    do {
      // Several of those that take the points out belong to each of those that put them in.
      if (++orders % (tests_take_fewer_rounds ? 97 : 5) != 0) continue;
      ChangingRegular3 changing;
      Present present;
      for (const std::size_t i : order) {
        present.add(sites[i], changing.insert(sites[i].point, sites[i].weight));
        expect_same(changing, present.points);
      }
      std::vector<std::size_t> out = order;
      std::rotate(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(orders % out.size()), out.end());
      for (const std::size_t i : out) {
        SCOPED_TRACE(reproduce(present.points) + " less " + reproduce({sites[i]}));
        const auto at = static_cast<std::size_t>(std::ranges::find(present.points, sites[i]) - present.points.begin());
        changing.remove(present.vertices[at]);
        present.erase(at);
        expect_same(changing, present.points);
      }
      if (HasFatalFailure()) return;
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(ChangingRegular3, InsertionAndRemovalRestore) {
  Random random(4);
  for (const SiteWeightFamily& family : testing::site_weight_families()) {
    for (const Cloud& cloud : testing::clouds(random, 24)) {
      SCOPED_TRACE(cloud.name + ", " + family.name);
      const std::vector<WeightedPoint3> sites = testing::weighted(cloud.points, family, random);
      ChangingRegular3 changing = triangulated(sites);
      const NumberedCells before = changing.canonical_cells(context);
      for (int i = 0; i < 6; ++i) {
        const Point3& p = cloud.points[random() % cloud.points.size()];
        const Point3& q = cloud.points[random() % cloud.points.size()];
        const Point3 middle{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
        changing.remove(changing.insert(middle, i % 2 == 0 ? family.weight(random) : 1e3));
        const NumberedCells after = changing.canonical_cells(context);
        ASSERT_EQ(after.ids, before.ids);
        ASSERT_TRUE(testing::are_same_cells(after.cells, before.cells));
      }
      expect_same(changing, sites);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(ChangingRegular3, OfEqualWeightsIsDelaunay) {
  Random random(5);
  for (const Cloud& cloud : testing::clouds(random, 40)) {
    SCOPED_TRACE(cloud.name);
    ChangingRegular3 regular;
    ChangingDelaunay3 delaunay;
    std::vector<std::array<std::uint32_t, 2>> vertices;
    for (const Point3& p : cloud.points) vertices.push_back({regular.insert(p, -0.75), delaunay.insert(p)});
    std::ranges::shuffle(vertices, random);
    for (std::size_t i = 0; i < vertices.size() / 2; ++i) {
      regular.remove(vertices[i][0]);
      delaunay.remove(vertices[i][1]);
    }
    EXPECT_EQ(regular.hidden_count(), 0U);
    ASSERT_TRUE(
        testing::are_same_cells(regular.canonical_cells(context).cells, delaunay.canonical_cells(context).cells));
  }
}

TEST(ChangingRegular3, HiddenPointsComeBack) {
  ChangingRegular3 changing;
  for (const Point3& p : {Point3{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}) changing.insert(p, 0);
  // The sphere about (1, 1, 1) of square radius 3; the point is at square distance 0.75 from its centre.
  const std::uint32_t below = changing.insert({0.5, 0.5, 0.5}, -2.25 + 0x1p-20);
  EXPECT_FALSE(changing.is_hidden(below));
  const std::uint32_t above = changing.insert({0.5, 0.5, 0.5}, -2.25 - 0x1p-20);
  EXPECT_TRUE(changing.is_hidden(above));
  changing.remove(below);
  EXPECT_TRUE(changing.is_hidden(above));
  EXPECT_EQ(changing.cells().size(), 5U);
  EXPECT_THROW(changing.star(above), InputError);
  EXPECT_THROW(changing.neighbours(above), InputError);
  // A corner goes: it is outside of what is left, then.
  const std::uint32_t apex = changing.insert({0, 0, 2}, 0);
  EXPECT_EQ(changing.multiplicity(apex), 2U);
  changing.remove(apex);
  EXPECT_TRUE(changing.is_hidden(above));
  changing.remove(apex);
  EXPECT_FALSE(changing.is_hidden(above));
  EXPECT_EQ(changing.dimension(), 3);
  EXPECT_EQ(changing.hidden_count(), 0U);
  EXPECT_EQ(changing.star(above).size(), 4U);
  EXPECT_EQ(changing.neighbours(above).size(), 3U);
}

/// One point hides all but the corners, in lists of one cell after the other; then they come back at once.
TEST(ChangingRegular3, OnePointHidesAllOthers) {
  Random random(6);
  std::vector<WeightedPoint3> sites;
  for (const Point3& p : testing::lattice(2, 2, 2)) sites.push_back({{4 * p.x - 2, 4 * p.y - 2, 4 * p.z - 2}, 0});
  for (const Point3& p : testing::random_points(random, test_rounds(1000U), testing::unit)) sites.push_back({p, 0});
  ChangingRegular3 changing;
  std::vector<std::uint32_t> vertices;
  for (const auto& [p, weight] : sites) vertices.push_back(changing.insert(p, weight));
  EXPECT_EQ(changing.hidden_count(), 0U);
  const std::uint32_t heavy = changing.insert({0, 0, 0}, 11.5);
  sites.push_back({{0, 0, 0}, 11.5});
  EXPECT_EQ(changing.hidden_count(), vertices.size() - 8);
  expect_same(changing, sites);
  // Some go and come while they are hidden, and the cells change, too.
  for (std::size_t i = 0; i < 20; ++i) {
    changing.remove(vertices.back());
    vertices.pop_back();
    sites.erase(sites.end() - 2);
    const Point3 beside{0.5 + 0.01 * static_cast<double>(i), 0.25, 0.75};
    const std::uint32_t v = changing.insert(beside, 8.5);
    expect_same(changing, [&] {
      std::vector<WeightedPoint3> more = sites;
      more.push_back({beside, 8.5});
      return more;
    }());
    changing.remove(v);
  }
  expect_same(changing, sites);
  changing.remove(heavy);
  sites.pop_back();
  EXPECT_EQ(changing.hidden_count(), 0U);
  expect_same(changing, sites);
}

/// The bounds of weights change on the way, and with them which tier decides.
TEST(ChangingRegular3, WeightsOfAllSizes) {
  Random random(7);
  for (int round = 0; round < test_rounds(6); ++round) {
    ChangingRegular3 changing;
    Present present;
    for (int step = 0; step < 200; ++step) {
      constexpr std::array<int, 8> sizes{-1074, -1000, -700, -60, 0, 2, 60, 1017};
      SCOPED_TRACE(reproduce(present.points));
      if (step % 100 < 60) {
        const int size = sizes[random() % 6 == 0 ? random() % sizes.size() : static_cast<std::size_t>(step / 12) % 8];
        Point3 p;
        for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = testing::small_integer(random, 4);
        const double weight = std::ldexp(testing::small_integer(random, 3), size);
        present.add({p, weight}, changing.insert(p, weight));
      } else if (!present.points.empty()) {
        const std::size_t which = random() % present.points.size();
        changing.remove(present.vertices[which]);
        present.erase(which);
      }
      if (step % 5 == 0) expect_same(changing, present.points);
      if (HasFatalFailure()) return;
    }
    // More go than are left, so that bounds are found anew.
    while (present.points.size() > 4) {
      changing.remove(present.vertices.back());
      present.erase(present.points.size() - 1);
    }
    expect_same(changing, present.points);
  }
}

/// Stars of more vertices than tables hold, with hidden points in them.
TEST(ChangingRegular3, LargeStars) {
  Random random(8);
  std::vector<WeightedPoint3> sites;
  for (const Point3& p : testing::near_sphere(random, 200)) sites.push_back({p, 0});
  for (const Point3& p : testing::near_sphere(random, 100)) sites.push_back({{p.x / 2, p.y / 2, p.z / 2}, -0.125});
  ChangingRegular3 changing = triangulated(sites);
  const std::uint32_t v = changing.insert({0, 0, 0}, 0.75);
  sites.push_back({{0, 0, 0}, 0.75});
  expect_same(changing, sites);
  EXPECT_GT(changing.neighbours(v).size(), 64U);
  EXPECT_GE(changing.hidden_count(), 100U);
  changing.remove(v);
  sites.pop_back();
  expect_same(changing, sites);
}

TEST(ChangingRegular3, StarsNeighboursAndPlacesAreThoseOfTheCells) {
  Random random(9);
  for (const SiteWeightFamily& family : testing::site_weight_families()) {
    for (const Cloud& cloud : testing::clouds(random, 24)) {
      SCOPED_TRACE(cloud.name + ", " + family.name);
      const ChangingRegular3 changing = triangulated(testing::weighted(cloud.points, family, random));
      if (changing.dimension() < 3) continue;
      for (std::uint32_t v = 0; v < changing.id_count(); ++v) {
        if (changing.is_hidden(v)) continue;
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
        EXPECT_EQ(changing.locate(changing.point(v)).kind, DelaunayLocation::Kind::vertex);
      }
    }
  }
}

TEST(ChangingRegular3, CopiesChangeAlone) {
  Random random(10);
  std::vector<WeightedPoint3> sites;
  for (const Point3& p : testing::random_points(random, 90, testing::unit)) {
    sites.push_back({p, testing::unit(random) / 2});
  }
  ChangingRegular3 changing = triangulated(sites);
  EXPECT_GT(changing.hidden_count(), 10U);
  ChangingRegular3 copy = changing;
  for (std::uint32_t v = 0; v < 45; ++v) copy.remove(v);
  expect_same(changing, sites);
  changing = copy;
  ChangingRegular3 moved = std::move(copy);
  moved.insert({0, 0, 0}, 1);
  std::vector<WeightedPoint3> rest;
  for (std::uint32_t v = 45; v < 90; ++v) rest.push_back({changing.point(v), changing.weight(v)});
  expect_same(changing, rest);
  rest.push_back({{0, 0, 0}, 1});
  expect_same(moved, rest);
}

}  // namespace
}  // namespace quoin
