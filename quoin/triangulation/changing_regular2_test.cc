// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_regular2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <new>
#include <set>
#include <tuple>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/triangulation/test_memory.h"
#include "quoin/triangulation/test_weights2.h"

namespace quoin {
namespace {

using testing::point_sets;
using testing::Random;
using testing::reproduce;
using testing::Weighted;

using Key = std::tuple<double, double, double>;
using Corners = std::array<Key, 3>;

Key key_of(const WeightedPoint2& p) {
  return {p.point.x + 0.0, p.point.y + 0.0, p.weight + 0.0};
}

// Infinite triangles too, by a place of their own.
template <class PointOf>
std::set<Corners> corners_of(std::span<const TriangleLinks2> triangles, std::size_t infinite, const PointOf& point_of) {
  constexpr double beyond = std::numeric_limits<double>::infinity();
  std::set<Corners> found;
  for (const TriangleLinks2& t : triangles) {
    Corners corners;
    for (unsigned slot = 0; slot < 3; ++slot) {
      corners[slot] = t.corner[slot] == infinite ? Key{beyond, beyond, beyond} : key_of(point_of(t.corner[slot]));
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    EXPECT_TRUE(found.insert(corners).second);
  }
  return found;
}

void expect_linked(std::span<const TriangleLinks2> triangles) {
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
}

// How often each point is there, as a vertex and hidden.
using Counts = std::map<Key, std::array<std::size_t, 2>>;

Counts counts_of(const Regular2& regular, const Weighted& points) {
  Counts counts;
  for (std::size_t v = 0; v < regular.vertex_count(); ++v) {
    counts[key_of(regular.point(Vertex2(v)))][0] += regular.inputs(Vertex2(v)).size();
  }
  for (const std::uint32_t input : regular.hidden()) ++counts[key_of(points[input])][1];
  return counts;
}

Counts counts_of(const ChangingRegular2& changing) {
  Counts counts;
  std::size_t hidden = 0;
  std::size_t vertices = 0;
  for (std::size_t i = 1; i < changing.id_count(); ++i) {
    const Vertex2 v(i);
    if (!changing.lives(v)) continue;
    ++(changing.is_hidden(v) ? hidden : vertices);
    auto& count = counts[key_of(changing.point(v))];
    EXPECT_EQ(count[0] + count[1], 0U);  // one id for each place and weight
    count[changing.is_hidden(v) ? 1 : 0] += changing.multiplicity(v);
    EXPECT_EQ(changing.find(changing.point(v)), v);
    if (changing.dimension() < 2 || changing.is_hidden(v)) continue;
    const Edge2 e = changing.edge_from(v);
    EXPECT_EQ(changing.triangles()[e.triangle().index()].corner[next_slot(e.slot())], v.value);
  }
  EXPECT_EQ(hidden, changing.hidden_count());
  EXPECT_EQ(vertices, changing.vertex_count());
  return counts;
}

// Linked as a sphere is, and the same triangles and hidden points as of the points that are there.
void expect_same(const ChangingRegular2& changing, const Weighted& points) {
  const Regular2 regular(points, Context({.threads = 1}));
  ASSERT_EQ(changing.dimension(), regular.dimension());
  ASSERT_EQ(changing.vertex_count(), regular.vertex_count());
  ASSERT_EQ(changing.line().size(), regular.line().size());
  for (std::size_t i = 0; i < regular.line().size(); ++i) {
    ASSERT_EQ(key_of(changing.point(changing.line()[i])), key_of(regular.point(regular.line()[i])));
  }
  ASSERT_NO_FATAL_FAILURE(expect_linked(changing.triangles()));
  ASSERT_EQ(
      corners_of(changing.triangles(), 0, [&](std::uint32_t v) { return changing.point(Vertex2(std::size_t{v})); }),
      corners_of(regular.links().links(), regular.vertex_count(),
                 [&](std::uint32_t v) { return regular.point(Vertex2(std::size_t{v})); }));
  ASSERT_EQ(counts_of(changing), counts_of(regular, points));
}

template <class Value>
void erase_at(std::vector<Value>& list, std::size_t at) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
}

// Points that come and go: more come at first, then all go.
struct Changes {
  Weighted points;
  std::vector<Vertex2> vertices;
  ChangingRegular2 changing;

  template <class Insert, class Remove>
  void run(Random& random, const Weighted& pool, int steps, const Insert& insert, const Remove& remove) {
    for (int step = 0; step < steps || !points.empty(); ++step) {
      const bool grows =
          step < steps && (points.empty() || random() % static_cast<unsigned>(steps) > static_cast<unsigned>(step));
      if (grows) {
        const WeightedPoint2 p = pool[random() % pool.size()];
        SCOPED_TRACE(reproduce(points) + "\nand then " + reproduce({p}));
        vertices.push_back(insert(p));
        points.push_back(p);
        expect_same(changing, points);
      } else {
        const std::size_t which = random() % points.size();
        SCOPED_TRACE(reproduce(points) + "\nbut then not " + reproduce({points[which]}));
        ASSERT_EQ(key_of(changing.point(vertices[which])), key_of(points[which]));
        remove(vertices[which]);
        erase_at(points, which);
        erase_at(vertices, which);
        expect_same(changing, points);
      }
      if (::testing::Test::HasFailure()) return;
    }
  }
};

TEST(ChangingRegular2, IsRegularAfterEachChange) {
  Random random(1);
  for (const auto& family : point_sets()) {
    for (const auto& weight : testing::plane_weight_families()) {
      for (int round = 0; round < test_rounds(3); ++round) {
        SCOPED_TRACE(std::string(family.name) + ", " + weight.name);
        Weighted pool = testing::weigh(random, family.make(random, 14), weight);
        // Some places twice, with other weights.
        for (int i = 0; i < 4; ++i) pool.push_back({pool[random() % pool.size()].point, weight.weight(random)});
        Changes changes;
        ChangingRegular2& changing = changes.changing;
        changes.run(
            random, pool, 40, [&](const WeightedPoint2& p) { return changing.insert(p); },
            [&](Vertex2 v) { changing.remove(v); });
        if (::testing::Test::HasFailure()) return;
      }
    }
  }
}

TEST(ChangingRegular2, HalfOfManyPoints) {
  Random random(2);
  for (const auto& family : point_sets()) {
    for (const auto& weight : testing::plane_weight_families()) {
      const Weighted points = testing::weigh(random, family.make(random, test_rounds(200)), weight);
      const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
      SCOPED_TRACE(std::string(family.name) + ", " + weight.name + ": " + reproduce(points));
      ChangingRegular2 changing(points);
      expect_same(changing, points);
      for (auto p = middle; p != points.end(); ++p) changing.remove(changing.find(*p));
      expect_same(changing, Weighted(points.begin(), middle));
      // In again, and all is as it was.
      for (auto p = middle; p != points.end(); ++p) changing.insert(*p);
      expect_same(changing, points);
      if (::testing::Test::HasFailure()) return;
    }
  }
}

// Of points of small integers, where ties and hiding abound.
TEST(ChangingRegular2, AllOrdersOfFewPoints) {
  Random random(3);
  for (int round = 0; round < test_rounds(60); ++round) {
    const int side = 1 + round % 2;
    Weighted points;
    for (int i = 0; i < 5; ++i) {
      points.push_back({{testing::small_integer(random, side), testing::small_integer(random, side)},
                        testing::small_integer(random, 1 + round % 3)});
    }
    std::array<std::size_t, 5> order{0, 1, 2, 3, 4};
    do {
      SCOPED_TRACE(reproduce(points));
      ChangingRegular2 changing;
      Weighted there;
      for (const std::size_t i : order) {
        changing.insert(points[i]);
        there.push_back(points[i]);
        if (round % 8 == 0) expect_same(changing, there);
      }
      expect_same(changing, there);
      for (const std::size_t i : order) {
        changing.remove(changing.find(points[i]));
        there.erase(there.begin());
        expect_same(changing, there);
      }
      if (::testing::Test::HasFailure()) return;
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(ChangingRegular2, AHeavyPointHidesManyUntilItGoes) {
  Random random(4);
  for (const auto& family : point_sets()) {
    Weighted points =
        testing::weigh(random, family.make(random, test_rounds(300)), testing::plane_weight_families()[0]);
    SCOPED_TRACE(family.name);
    ChangingRegular2 changing(points);
    const std::size_t hidden = changing.hidden_count();
    // Amid all, in the place of one, and beyond.
    const Point2 one = points[0].point;
    for (const Point2& place : {Point2{0.4, 0.6}, one, Point2{one.x + 1, one.y - 3}}) {
      points.push_back({place, 1e9});
      const Vertex2 heavy = changing.insert(points.back());
      expect_same(changing, points);
      if (changing.is_hidden(heavy)) continue;
      changing.remove(heavy);
      points.pop_back();
      expect_same(changing, points);
      EXPECT_EQ(changing.hidden_count(), hidden);
      if (::testing::Test::HasFailure()) return;
    }
  }
}

TEST(ChangingRegular2, HiddenPointsAndEqualOnes) {
  ChangingRegular2 changing;
  const Vertex2 light = changing.insert({{1, 1}, 2});
  const Vertex2 heavy = changing.insert({{1, 1}, 5});
  EXPECT_NE(light, heavy);
  EXPECT_TRUE(changing.is_hidden(light));
  EXPECT_EQ(changing.insert({{1, 1}, 2}), light);
  EXPECT_EQ(changing.multiplicity(light), 2U);
  EXPECT_EQ(changing.dimension(), 0);
  EXPECT_EQ(changing.find({{1, 1}, 5}), heavy);
  EXPECT_TRUE(changing.find({{1, 1}, 4}).is_none());
  changing.insert({{0, 0}, 0});
  changing.insert({{4, 0}, 0});
  changing.insert({{0, 4}, 0});
  EXPECT_EQ(changing.vertex_count(), 4U);
  EXPECT_EQ(changing.hidden_count(), 1U);
  changing.remove(heavy);
  EXPECT_FALSE(changing.is_hidden(light));
  EXPECT_EQ(changing.multiplicity(light), 2U);
  EXPECT_EQ(changing.vertex_count(), 4U);
  // Without the three about it, of which two are one too few for a plane.
  changing.insert({{2, 2}, -100});
  changing.insert({{3, 1}, -300});
  EXPECT_EQ(changing.hidden_count(), 2U);
  changing.remove(changing.find({{0, 0}, 0}));
  EXPECT_EQ(changing.hidden_count(), 2U);
  changing.remove(light);
  changing.remove(light);
  EXPECT_EQ(changing.dimension(), 1);
  EXPECT_EQ(changing.line().size(), 2U);
  EXPECT_EQ(changing.hidden_count(), 2U);
  changing.remove(changing.find({{4, 0}, 0}));
  EXPECT_EQ(changing.line().size(), 3U);
  EXPECT_EQ(changing.hidden_count(), 0U);
}

// The dimension stays where what was hidden is off the line of all other vertices.
TEST(ChangingRegular2, HiddenPointsKeepTheDimension) {
  Weighted points;
  for (int i = 0; i < 9; ++i) points.push_back({{static_cast<double>(i), 0}, 0});
  const std::size_t line = points.size();
  for (int i = 0; i < 5; ++i) points.push_back({{2.0 + 0.5 * i, 1.0 + i % 2}, -500});
  points.push_back({{4, 20}, 0});
  ChangingRegular2 changing(points);
  EXPECT_EQ(changing.vertex_count(), line + 1);
  changing.remove(changing.find(points.back()));
  points.pop_back();
  expect_same(changing, points);
  EXPECT_EQ(changing.dimension(), 2);
  while (points.size() > line) {
    changing.remove(changing.find(points.back()));
    points.pop_back();
    expect_same(changing, points);
  }
  EXPECT_EQ(changing.dimension(), 1);
}

// Makes each allocation of the change fail, one after the other, until it comes to its end.
template <class Change>
void change_with_failures(const ChangingRegular2& changing, const Weighted& before, const Change& change) {
  for (std::size_t allocation = 0;; ++allocation) {
    SCOPED_TRACE("allocation " + std::to_string(allocation));
    try {
      const testing::FailingAllocation failing(allocation);
      change();
      return;
    } catch (const std::bad_alloc&) {
    }
    expect_same(changing, before);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(ChangingRegular2, IsAsItWasWhereMemoryFails) {
  Random random(5);
  const auto& weights = testing::plane_weight_families();
  for (const auto& family : point_sets()) {
    for (std::size_t w = 0; w < 2; ++w) {
      SCOPED_TRACE(std::string(family.name) + ", " + weights[w].name);
      const Weighted pool = testing::weigh(random, family.make(random, 12), weights[w]);
      Changes changes;
      ChangingRegular2& changing = changes.changing;
      changes.run(
          random, pool, 24,
          [&](const WeightedPoint2& p) {
            Vertex2 v;
            change_with_failures(changing, changes.points, [&] { v = changing.insert(p); });
            return v;
          },
          [&](Vertex2 v) { change_with_failures(changing, changes.points, [&] { changing.remove(v); }); });
      if (::testing::Test::HasFailure()) return;
    }
  }
}

// Cancelled at each poll, one after the other, until the change comes to its end; how many polls there were.
template <class Change>
std::uint64_t change_with_cancellations(const ChangingRegular2& changing, const Weighted& before,
                                        const Change& change) {
  for (std::uint64_t polls = 0;; ++polls) {
    SCOPED_TRACE("poll " + std::to_string(polls));
    try {
      change(Context({.threads = 1, .most_polls = polls}));
      return polls;
    } catch (const Cancelled&) {
    }
    expect_same(changing, before);
    if (::testing::Test::HasFailure()) return polls;
  }
}

TEST(ChangingRegular2, LongChangesAreCancelledAndChangeNothing) {
  Weighted points;
  for (int i = 0; i < 600; ++i) points.push_back({{static_cast<double>(i), 2.0 * i}, i % 3 == 0 ? -50.0 : 0.0});
  ChangingRegular2 changing(points);
  EXPECT_GT(changing.hidden_count(), 100U);
  // The line is left, one point more is inserted, one that hides many, and one that is hidden.
  const Weighted more{{{300, 0}, 0}, {{299, 580}, 0}, {{300, 597}, 40000}, {{301, 597}, 0}};
  for (const WeightedPoint2& p : more) {
    EXPECT_GT(change_with_cancellations(changing, points, [&](const Context& context) { changing.insert(p, context); }),
              0U);
    points.push_back(p);
    expect_same(changing, points);
  }
  // What many were hidden by, stars of many triangles, and one whose removal leaves a line.
  for (const std::size_t i : {2U, 1U, 3U, 0U}) {
    const Vertex2 v = changing.find(more[i]);
    if (changing.is_hidden(v)) {
      changing.remove(v);
    } else {
      EXPECT_GT(
          change_with_cancellations(changing, points, [&](const Context& context) { changing.remove(v, context); }),
          1U);
    }
    points.erase(std::find_if(points.begin(), points.end(),
                              [&](const WeightedPoint2& p) { return key_of(p) == key_of(more[i]); }));
    expect_same(changing, points);
  }
  EXPECT_EQ(changing.dimension(), 1);
  const Vertex2 end = changing.line()[1];
  EXPECT_GT(change_with_cancellations(changing, points, [&](const Context& context) { changing.remove(end, context); }),
            0U);
}

TEST(ChangingRegular2, BadInputIsRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  ChangingRegular2 changing;
  EXPECT_THROW(changing.insert({{0, std::numeric_limits<double>::infinity()}, 0}), InputError);
  EXPECT_THROW(changing.insert({{0, 0}, nan}), InputError);
  EXPECT_THROW(changing.insert({{nan, 0}, 0}), InputError);
  EXPECT_THROW(changing.remove(Vertex2(0)), InputError);
  EXPECT_THROW(changing.remove(Vertex2(1)), InputError);
  EXPECT_THROW(changing.remove(Vertex2()), InputError);
  const Vertex2 v = changing.insert({{0.0, 2}, -0.0});
  EXPECT_EQ(changing.insert({{-0.0, 2}, 0.0}), v);
  changing.remove(v);
  changing.remove(v);
  EXPECT_THROW(changing.remove(v), InputError);
  EXPECT_EQ(changing.dimension(), -1);
  EXPECT_TRUE(changing.find({{nan, 0}, 0}).is_none());
}

// Ids are used again; copies change on their own.
TEST(ChangingRegular2, IdsStayWhilePointsLive) {
  Random random(6);
  const Weighted points =
      testing::weigh(random, testing::point_sets()[1].make(random, 200), testing::plane_weight_families()[0]);
  ChangingRegular2 changing(points);
  const ChangingRegular2 before = changing;
  std::vector<Vertex2> ids;
  for (const WeightedPoint2& p : points) ids.push_back(changing.find(p));
  const Vertex2 heavy = changing.insert({{0, 0}, 1e6});
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(changing.find(points[i]), ids[i]);
  changing.remove(heavy);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(changing.find(points[i]), ids[i]);
  EXPECT_EQ(changing.insert({{1e3, 0}, 0}), heavy);
  expect_same(before, points);
}

}  // namespace
}  // namespace quoin
