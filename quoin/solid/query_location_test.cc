// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/solid/query/line_classification.h"
#include "quoin/solid/query/point_location.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"

namespace quoin {
namespace {

const Context one_thread({.threads = 1});

Solid solid(const Mesh& mesh) {
  return Solid::from_leaf(make_leaf(mesh, {}, one_thread).leaf, one_thread);
}

struct GridBox {
  std::array<int, 3> lo;
  std::array<int, 3> hi;
};

std::vector<GridBox> random_boxes(std::mt19937& random, std::size_t count, int size) {
  std::vector<GridBox> boxes(count);
  for (GridBox& b : boxes) {
    for (std::size_t k = 0; k < 3; ++k) {
      do {
        b.lo[k] = static_cast<int>(random() % static_cast<unsigned>(size));
        b.hi[k] = static_cast<int>(random() % static_cast<unsigned>(size + 1));
      } while (b.lo[k] >= b.hi[k]);
    }
  }
  return boxes;
}

Point3 point(const std::array<int, 3>& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

std::vector<Solid> solids_of(const std::vector<GridBox>& boxes) {
  std::vector<Solid> solids;
  for (const GridBox& b : boxes) solids.push_back(solid(shapes::box(point(b.lo), point(b.hi))));
  return solids;
}

// Boxes with integer corners fill unit cubes: what surrounds a point of the half-integer grid tells where it lies.
class UnitCubes {
 public:
  explicit UnitCubes(std::vector<GridBox> boxes, bool odd) : boxes_(std::move(boxes)), odd_(odd) {}

  // Whether the unit cube that holds the point (2x, 2y, 2z) = p, moved a little in direction d, is filled.
  bool filled(const std::array<int, 3>& p, const std::array<int, 3>& d) const {
    int count = 0;
    for (const GridBox& b : boxes_) {
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k)
        inside = inside && 4 * b.lo[k] < 2 * p[k] + d[k] && 2 * p[k] + d[k] < 4 * b.hi[k];
      count += inside ? 1 : 0;
    }
    return odd_ ? count % 2 != 0 : count != 0;
  }

  Place place(const std::array<int, 3>& p) const {
    const auto octant = [&](unsigned o) {
      return filled(p, {(o & 1U) != 0 ? 1 : -1, (o & 2U) != 0 ? 1 : -1, (o & 4U) != 0 ? 1 : -1});
    };
    int same_along = 0;
    for (const unsigned axis : {1U, 2U, 4U}) {
      bool same = true;
      for (unsigned o = 0; o < 8; ++o) same = same && octant(o) == octant(o ^ axis);
      same_along += same ? 1 : 0;
    }
    if (same_along == 3) return octant(0) ? Place::in : Place::out;
    return same_along == 2 ? Place::on_face : same_along == 1 ? Place::on_edge : Place::on_vertex;
  }

 private:
  std::vector<GridBox> boxes_;
  bool odd_;
};

void expect_places(const Solid& s, const UnitCubes& cubes, int size, bool is_complement, const std::string& seed) {
  const SolidLocator locator(s.boundary(), one_thread);
  for (int x = -1; x <= 2 * size + 1; ++x) {
    for (int y = -1; y <= 2 * size + 1; ++y) {
      for (int z = -1; z <= 2 * size + 1; ++z) {
        Place expected = cubes.place({x, y, z});
        if (is_complement && !is_on_boundary(expected)) expected = expected == Place::in ? Place::out : Place::in;
        ASSERT_EQ(locator.locate(Point3{x * 0.5, y * 0.5, z * 0.5}).place, expected)
            << seed << " at " << x * 0.5 << " " << y * 0.5 << " " << z * 0.5;
      }
    }
  }
}

TEST(PointLocation, EveryPointOfAHalfIntegerGridAgainstUnitCubes) {
  for (unsigned seed = 0; seed < test_rounds(30U); ++seed) {
    std::mt19937 random(seed);
    const std::vector<GridBox> boxes = random_boxes(random, 5, 4);
    const std::vector<Solid> solids = solids_of(boxes);
    const Solid all = unite(solids, one_thread);
    const std::string name = "seed " + std::to_string(seed);
    expect_places(all, UnitCubes(boxes, false), 4, false, name);
    expect_places(symmetric_difference(solids, one_thread), UnitCubes(boxes, true), 4, false, name + " xor");
    expect_places(complement(all, one_thread), UnitCubes(boxes, false), 4, true, name + " complement");
  }
}

// Every vertex, middle of an edge and interior of a solid with constructed vertices is where its boundary says.
TEST(PointLocation, ElementsOfABoundaryWithConstructedVertices) {
  const Solid turned =
      solid(shapes::rotated(shapes::rotated(shapes::cube(1), shapes::Axis::x, 0.5), shapes::Axis::z, 0.3));
  const Solid s = intersect(std::array{solid(shapes::cube(1)), turned}, one_thread);
  const Brep& b = s.boundary();
  ASSERT_GT(b.face_count(), 6U);
  const SolidLocator locator(b, one_thread);
  for (std::size_t l = 0; l < b.loop_count(); ++l) {
    const auto loop = b.loop(l);
    RationalPoint3 mean{0, 0, 0};
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const PointId p = loop[i];
      const PointId q = loop[(i + 1) % loop.size()];
      const SolidLocation at_vertex = locator.locate(b.points.exact(p));
      EXPECT_EQ(at_vertex.place, Place::on_vertex);
      EXPECT_EQ(at_vertex.a, p);
      const SolidLocation at_edge = locator.locate((b.points.exact(p) + b.points.exact(q)) * Rational(0.5));
      EXPECT_EQ(at_edge.place, Place::on_edge);
      EXPECT_EQ(at_edge.a, std::min(p, q));
      EXPECT_EQ(at_edge.b, std::max(p, q));
      mean = mean + b.points.exact(p) * (Rational(1) / Rational(static_cast<std::int64_t>(loop.size())));
    }
    const SolidLocation at_face = locator.locate(mean);  // all faces are convex
    EXPECT_EQ(at_face.place, Place::on_face);
    const RationalPoint3 inside{0.5, 0.5, 0.5};
    const Rational tiny = Rational(1) / (Rational(Integer(1) << 200));
    EXPECT_EQ(locator.locate(mean + (inside - mean) * tiny).place, Place::in);
    EXPECT_EQ(locator.locate(mean - (inside - mean) * tiny).place, Place::out);
  }
}

TEST(PointLocation, AllThreadsGiveTheSame) {
  const Solid s = solid(shapes::torus(40, 20, 2, 1));
  std::vector<Point3> points;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-3, 3);
  for (int i = 0; i < 2000; ++i) points.push_back({coordinate(random), coordinate(random), coordinate(random) / 3});
  const Context two({.threads = 2});
  const SolidLocator locator(s.boundary(), two);
  const std::vector<SolidLocation> places = locate_all(locator, points, two);
  EXPECT_EQ(places, locate_all(locator, points, one_thread));
  std::size_t in = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    const double distance = std::hypot(std::hypot(p.x, p.y) - 2, p.z);
    if (distance < 0.9 || distance > 1) {
      EXPECT_EQ(places[i].place, distance < 1 ? Place::in : Place::out) << i;
    }
    in += places[i].place == Place::in ? 1 : 0;
  }
  EXPECT_GT(in, 200U);
}

TEST(LineClassification, ThroughACubeInEveryWay) {
  const Solid cube = solid(shapes::cube(1));
  const SolidLocator locator(cube.boundary(), one_thread);
  const auto cut = [&](const RationalPoint3& origin, const RationalPoint3& direction) {
    return classify_line(locator, {origin, direction}, one_thread);
  };
  const Rational half(0.5);
  const LineClassification through = cut({half, half, 5}, {0, 0, -2});
  ASSERT_EQ(through.events.size(), 2U);
  EXPECT_EQ(through.events[0].parameter, Rational(2));
  EXPECT_EQ(through.events[1].parameter, Rational(5) / Rational(2));
  EXPECT_EQ(through.events[0].location.place, Place::on_face);
  EXPECT_EQ(through.pieces[0].place, Place::out);
  EXPECT_EQ(through.pieces[1].place, Place::in);
  EXPECT_EQ(through.pieces[2].place, Place::out);
  const LineClassification diagonal = cut({0, 0, 0}, {1, 1, 1});
  ASSERT_EQ(diagonal.events.size(), 2U);
  EXPECT_EQ(diagonal.events[0].location.place, Place::on_vertex);
  EXPECT_EQ(diagonal.pieces[1].place, Place::in);
  const LineClassification along_face = cut({-1, half, 0}, {1, 0, 0});
  ASSERT_EQ(along_face.events.size(), 2U);
  EXPECT_EQ(along_face.events[0].location.place, Place::on_edge);
  EXPECT_EQ(along_face.pieces[1].place, Place::on_face);
  const LineClassification along_edge = cut({7, 0, 0}, {1, 0, 0});
  ASSERT_EQ(along_edge.events.size(), 2U);
  EXPECT_EQ(along_edge.events[0].location.place, Place::on_vertex);
  EXPECT_EQ(along_edge.pieces[1].place, Place::on_edge);
  const LineClassification touching = cut({1, 0, half}, {1, 1, 0});
  ASSERT_EQ(touching.events.size(), 1U);
  EXPECT_EQ(touching.events[0].location.place, Place::on_edge);
  EXPECT_EQ(touching.pieces[1].place, Place::out);
  EXPECT_TRUE(cut({3, 3, 3}, {1, 0, 0}).events.empty());
  EXPECT_THROW(cut({3, 3, 3}, {0, 0, 0}), InputError);
}

// Pieces alternate as the points in them say, on lines through grid points of boxes with coincident planes.
TEST(LineClassification, PiecesAreWhereTheirPointsAre) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const std::vector<GridBox> boxes = random_boxes(random, 5, 4);
    const Solid s = unite(solids_of(boxes), one_thread);
    const SolidLocator locator(s.boundary(), one_thread);
    for (int i = 0; i < 40; ++i) {
      const auto grid = [&] { return Rational(static_cast<int>(random() % 5)); };
      const auto step = [&] { return Rational(static_cast<int>(random() % 5) - 2); };
      const Line3 line{{grid(), grid(), grid()}, {step(), step(), step()}};
      if (line.direction == RationalPoint3{0, 0, 0}) continue;
      const LineClassification cut = classify_line(locator, line, one_thread);
      ASSERT_EQ(cut.pieces.size(), cut.events.size() + 1);
      for (const LineEvent& e : cut.events) ASSERT_TRUE(is_on_boundary(e.location.place));
      for (int k = -60; k <= 60; ++k) {
        const Rational t = Rational(k) / Rational(8);
        const Place expected = locator.locate(line.origin + line.direction * t).place;
        std::size_t piece = 0;
        bool is_event = false;
        for (const LineEvent& e : cut.events) {
          piece += e.parameter < t ? 1 : 0;
          is_event = is_event || e.parameter == t;
        }
        ASSERT_EQ(is_event ? cut.events[piece].location.place : cut.pieces[piece].place, expected)
            << "seed " << seed << " line " << i << " at " << k << "/8";
      }
    }
  }
}

}  // namespace
}  // namespace quoin
