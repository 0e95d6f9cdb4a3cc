// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <new>
#include <string>

#include "quoin/base/error.h"
#include "quoin/triangulation/changing_delaunay3.h"
#include "quoin/triangulation/test_changing3.h"
#include "quoin/triangulation/test_clouds.h"
#include "quoin/triangulation/test_memory.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::expect_same;
using testing::Present;
using testing::Random;
using testing::reproduce;

const Context context({.threads = 1});

/// Some changes of points of a cloud, each by `change(changing, before, act)`, where `act` makes it.
template <class Change>
void for_each_change(std::size_t size, const Change& change) {
  Random random(7);
  for (const Cloud& cloud : testing::clouds(random, size)) {
    ChangingDelaunay3 changing;
    Present present;
    const int steps = static_cast<int>(2 * size);
    for (int step = 0; step < steps; ++step) {
      SCOPED_TRACE(cloud.name + ": " + reproduce(present.points));
      // A copy has no memory to spare.
      if (step % 2 == 0) changing = ChangingDelaunay3(changing);
      if (present.points.empty() || random() % size > static_cast<unsigned>(step) / 2) {
        const Point3 p = cloud.points[random() % cloud.points.size()];
        std::uint32_t v = 0;
        change(changing, present.points, [&](const Context& with) { v = changing.insert(p, with); });
        present.add(p, v);
      } else {
        const std::size_t which = random() % present.points.size();
        change(changing, present.points, [&](const Context& with) { changing.remove(present.vertices[which], with); });
        present.erase(which);
      }
      expect_same(changing, present.points);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(ChangingDelaunay3, IsAsItWasWhereMemoryFails) {
  std::size_t failures = 0;
  for_each_change(10,
                  [&failures](const ChangingDelaunay3& changing, const std::vector<Point3>& before, const auto& act) {
                    for (std::size_t allocation = 0;; ++allocation) {
                      SCOPED_TRACE("allocation " + std::to_string(allocation));
                      try {
                        const testing::FailingAllocation failing(allocation);
                        act(context);
                        return;
                      } catch (const std::bad_alloc&) {
                        ++failures;
                      }
                      expect_same(changing, before);
                      if (::testing::Test::HasFatalFailure()) return;
                    }
                  });
  EXPECT_GT(failures, 500U);
}

/// Of a star that takes no table, and as many points as have a grid.
TEST(ChangingDelaunay3, LargeStarsAreAsTheyWereWhereMemoryFails) {
  Random random(12);
  std::vector<Point3> points = testing::near_sphere(random, 72);
  ChangingDelaunay3 changing(points, context);
  const auto expect_failures = [&](const auto& act) {
    ChangingDelaunay3 copy = changing;
    std::size_t allocation = 0;
    for (bool has_failed = true; has_failed; ++allocation) {
      try {
        const testing::FailingAllocation failing(allocation);
        act(copy);
        has_failed = false;
      } catch (const std::bad_alloc&) {
        expect_same(copy, points);
      }
    }
    EXPECT_GT(allocation, 5U);
    changing = copy;
  };
  std::uint32_t v = 0;
  expect_failures([&v](ChangingDelaunay3& copy) { v = copy.insert({0, 0, 0}); });
  points.push_back({0, 0, 0});
  EXPECT_GT(changing.neighbours(v).size(), 64U);
  expect_failures([v](ChangingDelaunay3& copy) { copy.remove(v); });
  points.pop_back();
  expect_same(changing, points);
}

TEST(ChangingDelaunay3, IsAsItWasWhereItIsCancelled) {
  std::size_t failures = 0;
  for_each_change(8,
                  [&failures](const ChangingDelaunay3& changing, const std::vector<Point3>& before, const auto& act) {
                    for (std::uint64_t polls = 0;; ++polls) {
                      SCOPED_TRACE("polls " + std::to_string(polls));
                      try {
                        act(Context({.threads = 1, .most_polls = polls}));
                        return;
                      } catch (const Cancelled&) {
                        ++failures;
                      }
                      expect_same(changing, before);
                      if (::testing::Test::HasFatalFailure()) return;
                    }
                  });
  EXPECT_GT(failures, 200U);
}

/// What takes long asks more often than once whether to go on.
TEST(ChangingDelaunay3, LongChangesAreCancelledAndChangeNothing) {
  Random random(8);
  std::vector<Point3> points = testing::near_sphere(random, 400);
  ChangingDelaunay3 changing(points, context);
  const auto expect_cancelled = [&](const auto& act) {
    std::uint64_t polls = 0;
    for (;; polls += 1 + polls / 4) {
      try {
        act(Context({.threads = 1, .most_polls = polls}));
        break;
      } catch (const Cancelled&) {
      }
      expect_same(changing, points);
    }
    EXPECT_GT(polls, 2U);
  };
  std::uint32_t v = 0;
  expect_cancelled([&](const Context& with) { v = changing.insert({0, 0, 0}, with); });
  points.push_back({0, 0, 0});
  expect_cancelled([&](const Context& with) { changing.remove(v, with); });
  points.pop_back();
  expect_same(changing, points);
}

TEST(ChangingDelaunay3, BadInputIsRefused) {
  ChangingDelaunay3 changing;
  EXPECT_THROW(changing.insert({0, std::numeric_limits<double>::infinity(), 0}), InputError);
  EXPECT_THROW(changing.insert({std::numeric_limits<double>::quiet_NaN(), 0, 0}), InputError);
  EXPECT_THROW(changing.remove(0), InputError);
  EXPECT_THROW(changing.remove(vertex_at_infinity), InputError);
  EXPECT_THROW(changing.remove(no_vertex), InputError);
  const std::vector<Point3> bad{{0, 0, 0}, {0, 0, -std::numeric_limits<double>::infinity()}};
  EXPECT_THROW(ChangingDelaunay3(bad, context), InputError);
  const std::uint32_t v = changing.insert({1, 2, 3});
  EXPECT_EQ(changing.insert({1, 2, 3}), v);
  EXPECT_EQ(changing.multiplicity(v), 2U);
  changing.remove(v);
  changing.remove(v);
  EXPECT_THROW(changing.remove(v), InputError);
  EXPECT_EQ(changing.dimension(), -1);
  // The apex of a plane has an id, but is not there.
  for (const Point3& p : testing::lattice(2, 2, 1)) changing.insert(p);
  EXPECT_EQ(changing.vertex_count(), 4U);
  for (std::uint32_t id = 0; id < changing.id_count(); ++id) {
    if (changing.lives(id)) continue;
    EXPECT_THROW(changing.remove(id), InputError);
  }
  // Both zeros are one.
  EXPECT_EQ(changing.multiplicity(changing.insert({-0.0, 0, -0.0})), 2U);
  EXPECT_THROW(changing.star(0), InputError);
  EXPECT_THROW(changing.neighbours(no_vertex), InputError);
  EXPECT_EQ(changing.locate({0, 0, 0}).kind, DelaunayLocation::Kind::vertex);
  EXPECT_EQ(changing.locate({0.5, 0, 0}).kind, DelaunayLocation::Kind::edge);
  EXPECT_EQ(changing.locate({0, 0, 1}).kind, DelaunayLocation::Kind::outside_affine_hull);
  EXPECT_THROW(changing.locate({0, 0, std::numeric_limits<double>::infinity()}), InputError);
  EXPECT_THROW(changing.nearest({0, 0, std::numeric_limits<double>::quiet_NaN()}), InputError);
  const ChangingDelaunay3 none(std::vector<Point3>{}, context);
  EXPECT_THROW(none.locate({0, 0, 0}), InputError);
  EXPECT_EQ(none.dimension(), -1);
  EXPECT_THROW(none.nearest({0, 0, 0}), InputError);
  EXPECT_TRUE(none.canonical_cells(context).cells.empty());
}

}  // namespace
}  // namespace quoin
