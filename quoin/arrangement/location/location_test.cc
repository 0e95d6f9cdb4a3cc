// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/location/location.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <thread>

#include "quoin/arrangement/linear/linear_editing.h"
#include "quoin/arrangement/linear/linear_location.h"
#include "quoin/arrangement/location/location_scenes.h"
#include "quoin/arrangement/location/locator_watch.h"
#include "quoin/arrangement/location/walk_locator.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

std::string name(Location l) {
  const char* kinds[] = {"vertex ", "edge ", "face "};
  return kinds[static_cast<int>(l.kind())] + std::to_string(l.index());
}

TEST(PointLocation, AllStrategiesAgreeWithScans) {
  for (const Scene& scene : location_scenes()) {
    SCOPED_TRACE(scene.name);
    const NaiveLocator<LinearFamily> naive(scene.arrangement);
    const TrapezoidLocator<LinearFamily> trapezoids(scene.arrangement);
    const WalkLocator<LinearFamily> walk(scene.arrangement);
    const GridLocator<LinearFamily> grid(scene.arrangement);
    const std::vector<Location> batch =
        locate_batch(scene.arrangement, std::span<const LinearPoint>(scene.queries), Context());
    for (std::size_t i = 0; i < scene.queries.size(); ++i) {
      const LinearPoint& p = scene.queries[i];
      SCOPED_TRACE(::testing::Message() << "query " << i << " (" << p.x << ", " << p.y << ")");
      const Location expected = naive.locate(p);
      ASSERT_EQ(name(trapezoids.locate(p)), name(expected));
      ASSERT_EQ(name(walk.locate(p)), name(expected));
      ASSERT_EQ(name(grid.locate(p)), name(expected));
      ASSERT_EQ(name(batch[i]), name(expected));
    }
  }
}

TEST(PointLocation, RaysAgreeWithScans) {
  for (const Scene& scene : location_scenes()) {
    SCOPED_TRACE(scene.name);
    const NaiveLocator<LinearFamily> naive(scene.arrangement);
    const TrapezoidLocator<LinearFamily> trapezoids(scene.arrangement);
    const WalkLocator<LinearFamily> walk(scene.arrangement);
    for (std::size_t i = 0; i < scene.queries.size(); ++i) {
      const LinearPoint& p = scene.queries[i];
      for (const Direction direction : {Direction::down, Direction::up}) {
        SCOPED_TRACE(::testing::Message() << "query " << i << " (" << p.x << ", " << p.y << ") "
                                          << (direction == Direction::up ? "up" : "down"));
        const Location expected = naive.shoot(p, direction);
        ASSERT_EQ(name(trapezoids.shoot(p, direction)), name(expected));
        ASSERT_EQ(name(walk.shoot(p, direction)), name(expected));
      }
    }
  }
}

/// The arrangement with x and y exchanged, of its own edges and isolated vertices.
LinearArrangement transposed(const LinearArrangement& a, std::vector<LinearPoint>& queries) {
  const auto swapped = [](const RationalPoint2& p) { return RationalPoint2{p.y, p.x}; };
  const LinearFamily& old = a.family();
  LinearFamily family;
  PieceList<LinearFamily> list;
  for (std::size_t i = 0; i < a.edge_count(); ++i) {
    const dcel::EdgeId e(i);
    if (!a.cells().is_real(e)) continue;
    const RationalPoint2 first = swapped(old.first_support_point(a.branch(e)));
    const RationalPoint2 second = swapped(old.second_support_point(a.branch(e)));
    const BranchId line = family.add_line(first, second, "edge");
    const bool is_forward = first.x != second.x ? first.x < second.x : first.y < second.y;
    const auto end = [&](const LinearPoint& p, bool is_last) {
      if (!p.is_end()) return family.point(swapped(old.exact(p)));
      return is_last == is_forward ? family.last_end(line) : family.first_end(line);
    };
    Piece piece{line, list.add_point(end(a.left_point(e), false)), list.add_point(end(a.right_point(e), true)),
                CurveId(std::size_t{list.curve_count++}), false};
    if (!is_forward) std::swap(piece.left, piece.right);
    list.pieces.push_back(piece);
  }
  for (std::size_t i = 0; i < a.vertex_count(); ++i) {
    const dcel::VertexId v(i);
    if (!a.cells().is_real(v) || !a.cells().is_isolated(v)) continue;
    const CurveId curve(std::size_t{list.curve_count++});
    list.lone_points.push_back({list.add_point(family.point(swapped(old.exact(a.point(v))))), curve});
  }
  for (LinearPoint& p : queries) p = family.point(swapped(old.exact(p)));
  return arrange(std::move(family), list, Context());
}

/// Two points lie in one cell if and only if they do so with x and y exchanged: an oracle for faces that shares nothing
/// with the direction in which locators look.
TEST(PointLocation, ExchangedCoordinatesGiveTheSameCells) {
  for (const Scene& scene : location_scenes()) {
    SCOPED_TRACE(scene.name);
    std::vector<LinearPoint> queries = scene.queries;
    const LinearArrangement other = transposed(scene.arrangement, queries);
    ASSERT_EQ(other.counts().faces, scene.arrangement.counts().faces);
    const std::vector<Location> here =
        locate_batch(scene.arrangement, std::span<const LinearPoint>(scene.queries), Context());
    const std::vector<Location> there = locate_batch(other, std::span<const LinearPoint>(queries), Context());
    std::map<Location, Location> partner;
    std::map<Location, Location> back;
    for (std::size_t i = 0; i < here.size(); ++i) {
      ASSERT_EQ(partner.emplace(here[i], there[i]).first->second, there[i]) << "query " << i;
      ASSERT_EQ(back.emplace(there[i], here[i]).first->second, here[i]) << "query " << i;
    }
  }
}

TEST(PointLocation, ManyQueriesAgree) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    const LinearArrangement a = random_segments(test_rounds(2000), 0.01 * std::pow(4, seed), seed);
    std::vector<LinearPoint> queries;
    for (std::size_t i = 0; i < a.vertex_count(); ++i) queries.push_back(a.point(dcel::VertexId(i)));
    for (std::size_t i = 0; i < a.edge_count(); ++i) {
      const Point2 p = a.family().position(a.left_point(dcel::EdgeId(i)));
      const Point2 q = a.family().position(a.right_point(dcel::EdgeId(i)));
      queries.push_back(LinearFamily::point(Point2{(p.x + q.x) / 2, (p.y + q.y) / 2}));
    }
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-0.1, 1.1);
    while (queries.size() < test_rounds(std::size_t{100'000}))
      queries.push_back(LinearFamily::point(Point2{any(random), any(random)}));
    const NaiveLocator<LinearFamily> naive(a);
    const TrapezoidLocator<LinearFamily> trapezoids(a);
    const GridLocator<LinearFamily> grid(a);
    const std::vector<Location> batch = locate_batch(a, std::span<const LinearPoint>(queries), Context());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed << " query " << i);
      ASSERT_EQ(name(trapezoids.locate(queries[i])), name(batch[i]));
      ASSERT_EQ(name(grid.locate(queries[i])), name(batch[i]));
      if (i % 1009 == 0) {
        ASSERT_EQ(name(naive.locate(queries[i])), name(batch[i]));
      }
    }
  }
}

/// Many curves in one cell, long and steep ones, coordinates of all sizes: where grids are at a loss.
TEST(PointLocation, GridsOfUnevenArrangements) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int kind = 0; kind < 6; ++kind) {
    LinearFamily family;
    PieceList<LinearFamily> list;
    std::vector<LinearPoint> queries;
    for (int i = 0; i < 300; ++i) {
      const Point2 a{unit(random), unit(random)};
      const Point2 b{unit(random), unit(random)};
      const double scale = std::pow(2, -200 * unit(random));
      if (kind == 0) family.add_segment(list, Point2{0.5, 0.5}, a);
      if (kind == 1) family.add_segment(list, a, Point2{a.x + 1e-9, b.y});
      if (kind == 2) family.add_segment(list, a, Point2{b.x, a.y + 1e-9});
      if (kind == 3) family.add_segment(list, Point2{scale * a.x, scale * a.y}, Point2{scale * b.x, scale * a.y * 1.1});
      if (kind == 4 && i < 60) family.add_line(list, a, b, "line");
      if (kind == 5) family.add_point(list, a);
      const double size = kind == 3 ? 2 * scale : kind == 4 ? 100 : 1;
      queries.push_back(LinearFamily::point(Point2{size * unit(random), size * (unit(random) - 0.1)}));
      queries.push_back(LinearFamily::point(Point2{a.x, unit(random)}));
      queries.push_back(LinearFamily::point(a));
    }
    const LinearArrangement a = arrange(std::move(family), list, Context());
    for (std::size_t i = 0; i < a.vertex_count(); i += 7) {
      if (a.cells().is_real(dcel::VertexId(i))) queries.push_back(a.point(dcel::VertexId(i)));
    }
    const GridLocator<LinearFamily> grid(a);
    const NaiveLocator<LinearFamily> naive(a);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      ASSERT_EQ(name(grid.locate(queries[i])), name(naive.locate(queries[i]))) << "kind " << kind << " query " << i;
    }
  }
}

TEST(PointLocation, PathsOfTheMapAreShort) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const LinearArrangement a = random_segments(4000, 0.03, seed);
    ContextOptions options;
    options.seed = seed;
    const TrapezoidLocator<LinearFamily> map(a, Context(options));
    const double levels = std::log2(static_cast<double>(a.edge_count()));
    EXPECT_LT(static_cast<double>(map.depth()), 6 * levels + 20);
    double steps = 0;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 1000; ++i) {
      steps += static_cast<double>(map.steps(LinearFamily::point(Point2{unit(random), unit(random)})));
    }
    EXPECT_LT(steps / 1000, 3 * levels);
    EXPECT_LT(map.node_count(), 10 * a.edge_count());
  }
}

TEST(PointLocation, SeveralThreadsMayAsk) {
  const LinearArrangement a = random_segments(500, 0.1, 1);
  const TrapezoidLocator<LinearFamily> trapezoids(a);
  const GridLocator<LinearFamily> grid(a);
  std::vector<std::thread> threads;
  std::vector<std::size_t> differences(4, 0);
  for (unsigned t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      std::mt19937 random(t);
      std::uniform_real_distribution<double> unit(0, 1);
      for (int i = 0; i < 2000; ++i) {
        const LinearPoint p = LinearFamily::point(Point2{unit(random), unit(random)});
        differences[t] += static_cast<std::size_t>(trapezoids.locate(p) != grid.locate(p));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(differences, std::vector<std::size_t>(4, 0));
}

TEST(PointLocation, WatchedArrangementsMayBeEdited) {
  LinearArrangement a = random_segments(20, 0.5, 1);
  TrapezoidLocator<LinearFamily> trapezoids(a);
  GridLocator<LinearFamily> grid(a);
  LocatorWatch watch(trapezoids);
  LocatorWatch grid_watch(grid);
  a.attach(watch);
  a.attach(grid_watch);
  const NaiveLocator<LinearFamily> naive(a);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto draw = [&] { return Point2{unit(random), unit(random)}; };
  for (int round = 0; round < 20; ++round) {
    LinearFamily family;
    PieceList<LinearFamily> list;
    if (round % 5 == 4) {
      family.add_line(list, draw(), draw(), "line");
    } else {
      family.add_segment(list, draw(), draw());
    }
    const CurveId curve = insert(a, family, list, Context(), {});
    if (round % 3 == 2) remove_curve(a, curve, {});
    EXPECT_TRUE(trapezoids.is_stale());
    EXPECT_GT(watch.changes(), 0U);
    if (round % 2 == 0) {
      watch.refresh(Context());
      grid_watch.refresh(Context());
    }
    for (int i = 0; i < 100; ++i) {
      const LinearPoint p = LinearFamily::point(draw());
      const Location expected = naive.locate(p);
      ASSERT_EQ(name(trapezoids.locate(p)), name(expected)) << "round " << round;
      ASSERT_EQ(name(grid.locate(p)), name(expected)) << "round " << round;
      ASSERT_EQ(name(locate_batch(a, std::span<const LinearPoint>(&p, 1), Context())[0]), name(expected));
    }
  }
}

TEST(PointLocation, StaleLocatorsFollowTheArrangement) {
  LinearArrangement a = random_segments(50, 0.3, 1);
  TrapezoidLocator<LinearFamily> trapezoids(a);
  GridLocator<LinearFamily> grid(a);
  WalkLocator<LinearFamily> walk(a);
  a = random_segments(70, 0.4, 2);
  const NaiveLocator<LinearFamily> naive(a);
  trapezoids.mark_stale();
  grid.mark_stale();
  walk.mark_stale();
  for (const bool is_rebuilt : {false, true}) {
    if (is_rebuilt) {
      trapezoids.rebuild(Context());
      grid.rebuild(Context());
      walk.rebuild(Context());
    }
    EXPECT_EQ(trapezoids.is_stale(), !is_rebuilt);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 300; ++i) {
      const LinearPoint p = LinearFamily::point(Point2{unit(random), unit(random)});
      const Location expected = naive.locate(p);
      ASSERT_EQ(trapezoids.locate(p), expected);
      ASSERT_EQ(grid.locate(p), expected);
      ASSERT_EQ(walk.locate(p), expected);
      ASSERT_EQ(trapezoids.shoot(p, Direction::up), naive.shoot(p, Direction::up));
    }
  }
}

}  // namespace
}  // namespace quoin
