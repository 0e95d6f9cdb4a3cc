// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <new>
#include <string>

#include "quoin/base/error.h"
#include "quoin/triangulation/test_changing_regular3.h"
#include "quoin/triangulation/test_memory.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::expect_same;
using testing::Random;
using testing::reproduce;
using testing::SiteWeightFamily;
using Present = testing::PresentSites<WeightedPoint3>;

const Context context({.threads = 1});

/// Some changes of weighted points of a cloud, each by `change(changing, before, act)`, where `act` makes it.
template <class Change>
void for_each_change(std::size_t size, const Change& change) {
  Random random(7);
  std::size_t next = 0;
  for (const Cloud& cloud : testing::clouds(random, size)) {
    const SiteWeightFamily& family = testing::site_weight_families()[next++ % testing::site_weight_families().size()];
    ChangingRegular3 changing;
    Present present;
    const int steps = static_cast<int>(2 * size);
    for (int step = 0; step < steps; ++step) {
      SCOPED_TRACE(cloud.name + ", " + family.name + ": " + reproduce(present.points));
      // A copy has no memory to spare.
      if (step % 2 == 0) changing = ChangingRegular3(changing);
      if (present.points.empty() || random() % size > static_cast<unsigned>(step) / 2) {
        const double weight = step % 3 == 0 ? 0.5 : family.weight(random);
        const WeightedPoint3 site{cloud.points[random() % cloud.points.size()], weight};
        std::uint32_t v = 0;
        change(changing, present.points,
               [&](const Context& with) { v = changing.insert(site.point, site.weight, with); });
        present.add(site, v);
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

/// Tries it with each allocation failing, until none does.
template <class Act, class Check>
std::size_t count_failures(const Act& act, const Check& check) {
  for (std::size_t allocation = 0;; ++allocation) {
    SCOPED_TRACE("allocation " + std::to_string(allocation));
    try {
      const testing::FailingAllocation failing(allocation);
      act();
      return allocation;
    } catch (const std::bad_alloc&) {
    }
    check();
    if (::testing::Test::HasFatalFailure()) return allocation;
  }
}

TEST(ChangingRegular3, IsAsItWasWhereMemoryFails) {
  std::size_t failures = 0;
  for_each_change(10, [&failures](const ChangingRegular3& changing, const auto& before, const auto& act) {
    failures += count_failures([&] { act(context); }, [&] { expect_same(changing, before); });
  });
  EXPECT_GT(failures, 500U);
}

/// Of a star that takes no table, with points that are hidden and come back.
TEST(ChangingRegular3, LargeStarsAreAsTheyWereWhereMemoryFails) {
  Random random(12);
  std::vector<WeightedPoint3> sites;
  for (const Point3& p : testing::near_sphere(random, 72)) sites.push_back({p, 0});
  for (const Point3& p : testing::near_sphere(random, 20)) sites.push_back({{p.x / 2, p.y / 2, p.z / 2}, 0});
  ChangingRegular3 changing(testing::points_of(sites), testing::weights_of(sites), context);
  const auto expect_failures = [&](const auto& act) {
    ChangingRegular3 copy = changing;
    EXPECT_GT(count_failures([&] { act(copy); }, [&] { expect_same(copy, sites); }), 5U);
    changing = copy;
  };
  std::uint32_t v = 0;
  expect_failures([&v](ChangingRegular3& copy) { v = copy.insert({0, 0, 0}, 0.75); });
  sites.push_back({{0, 0, 0}, 0.75});
  expect_same(changing, sites);
  EXPECT_GT(changing.neighbours(v).size(), 64U);
  EXPECT_GE(changing.hidden_count(), 15U);
  expect_failures([v](ChangingRegular3& copy) { copy.remove(v); });
  sites.pop_back();
  expect_same(changing, sites);
}

TEST(ChangingRegular3, TooLittleMemoryForTheFirstCellsIsSaid) {
  for (const std::vector<Point3>& points :
       {testing::lattice(3, 2, 3), testing::lattice(3, 4, 1), testing::lattice(1, 4, 1)}) {
    std::vector<Point3> twice = points;
    twice.insert(twice.end(), points.begin(), points.end());
    std::vector<double> weights(twice.size(), 1);
    for (std::size_t i = 0; i < points.size(); i += 2) weights[i] = -static_cast<double>(i);
    bool has_failed = true;
    for (std::size_t allocation = 0; has_failed; ++allocation) {
      const testing::FailingAllocation failing(allocation);
      try {
        const ChangingRegular3 changing(twice, weights, context);
        ASSERT_FALSE(failing.has_failed()) << allocation;
        has_failed = false;
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find("too little memory"), 0U) << error.what();
      }
    }
  }
}

TEST(ChangingRegular3, IsAsItWasWhereItIsCancelled) {
  std::size_t failures = 0;
  for_each_change(8, [&failures](const ChangingRegular3& changing, const auto& before, const auto& act) {
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
TEST(ChangingRegular3, LongChangesAreCancelledAndChangeNothing) {
  Random random(8);
  std::vector<WeightedPoint3> sites;
  for (const Point3& p : testing::near_sphere(random, 300)) sites.push_back({p, 0});
  for (const Point3& p : testing::near_sphere(random, 300)) sites.push_back({{p.x / 2, p.y / 2, p.z / 2}, 0});
  ChangingRegular3 changing(testing::points_of(sites), testing::weights_of(sites), context);
  const auto expect_cancelled = [&](const auto& act) {
    std::uint64_t polls = 0;
    for (;; polls += 1 + polls / 4) {
      try {
        act(Context({.threads = 1, .most_polls = polls}));
        break;
      } catch (const Cancelled&) {
      }
      expect_same(changing, sites);
    }
    EXPECT_GT(polls, 2U);
  };
  std::uint32_t v = 0;
  expect_cancelled([&](const Context& with) { v = changing.insert({0, 0, 0}, 0.75, with); });
  sites.push_back({{0, 0, 0}, 0.75});
  expect_same(changing, sites);
  expect_cancelled([&](const Context& with) { changing.remove(v, with); });
  sites.pop_back();
  expect_same(changing, sites);
}

TEST(ChangingRegular3, BadInputIsRefused) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  ChangingRegular3 changing;
  EXPECT_THROW(changing.insert({0, infinity, 0}, 0), InputError);
  EXPECT_THROW(changing.insert({nan, 0, 0}, 0), InputError);
  EXPECT_THROW(changing.insert({0, 0, 0}, nan), InputError);
  EXPECT_THROW(changing.insert({0, 0, 0}, -infinity), InputError);
  EXPECT_EQ(changing.vertex_count(), 0U);
  for (const std::uint32_t v : {0U, 7U, vertex_at_infinity, no_vertex}) {
    EXPECT_THROW(changing.remove(v), InputError);
    EXPECT_FALSE(changing.is_hidden(v));
  }
  const std::vector<Point3> two{{0, 0, 0}, {0, 0, 1}};
  EXPECT_THROW(ChangingRegular3(two, std::vector<double>{0}, context), InputError);
  EXPECT_THROW(ChangingRegular3(two, std::vector<double>{0, nan}, context), InputError);
  EXPECT_THROW(ChangingRegular3(std::vector<Point3>{{0, 0, 0}, {0, 0, -infinity}}, std::vector<double>{0, 0}, context),
               InputError);
  // Both zeros are one, of weights, too.
  const std::uint32_t v = changing.insert({0.0, 2, 3}, 0.0);
  EXPECT_EQ(changing.insert({-0.0, 2, 3}, -0.0), v);
  EXPECT_EQ(changing.multiplicity(v), 2U);
  const std::uint32_t heavier = changing.insert({0, 2, 3}, 1);
  EXPECT_NE(heavier, v);
  EXPECT_TRUE(changing.is_hidden(v));
  EXPECT_EQ(changing.dimension(), 0);
  changing.remove(heavier);
  EXPECT_FALSE(changing.is_hidden(v));
  EXPECT_THROW(changing.remove(heavier), InputError);
  changing.remove(v);
  changing.remove(v);
  EXPECT_THROW(changing.remove(v), InputError);
  EXPECT_EQ(changing.dimension(), -1);
  // The apex of a plane has an id, but is not there.
  for (const Point3& p : testing::lattice(2, 2, 1)) changing.insert(p, 1);
  EXPECT_EQ(changing.vertex_count(), 4U);
  for (std::uint32_t id = 0; id < changing.id_count(); ++id) {
    if (changing.lives(id)) continue;
    EXPECT_THROW(changing.remove(id), InputError);
    EXPECT_THROW(changing.neighbours(id), InputError);
  }
  EXPECT_THROW(changing.star(0), InputError);
  EXPECT_EQ(changing.locate({0, 0, 0}).kind, DelaunayLocation::Kind::vertex);
  EXPECT_EQ(changing.locate({0.5, 0, 0}).kind, DelaunayLocation::Kind::edge);
  EXPECT_EQ(changing.locate({0, 0, 1}).kind, DelaunayLocation::Kind::outside_affine_hull);
  EXPECT_THROW(changing.locate({0, 0, std::numeric_limits<double>::infinity()}), InputError);
  const ChangingRegular3 none(std::vector<Point3>{}, std::vector<double>{}, context);
  EXPECT_THROW(none.locate({0, 0, 0}), InputError);
  EXPECT_EQ(none.dimension(), -1);
  EXPECT_TRUE(none.canonical_cells(context).cells.empty());
}

}  // namespace
}  // namespace quoin
