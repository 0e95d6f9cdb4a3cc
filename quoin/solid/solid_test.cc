// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/io/exact_text.h"
#include "quoin/solid/check.h"
#include "quoin/solid/exit.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/query/section.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/topology_counts.h"

namespace quoin {
namespace {

const Context one_thread({.threads = 1});

Solid solid(const Mesh& mesh) {
  const LeafResult result = make_leaf(mesh, {}, one_thread);
  EXPECT_NE(result.leaf, nullptr);
  return Solid::from_leaf(result.leaf, one_thread);
}

Solid box(const Point3& lo, const Point3& hi) {
  return solid(shapes::box(lo, hi));
}

Rational volume_of(const Solid& s) {
  return volume(s.boundary(), one_thread);
}

Solid unite_two(const Solid& a, const Solid& b) {
  return unite(std::array{a, b}, one_thread);
}
Solid intersect_two(const Solid& a, const Solid& b) {
  return intersect(std::array{a, b}, one_thread);
}
Solid minus(const Solid& a, const Solid& b) {
  return subtract(a, {&b, 1}, one_thread);
}

// Volume, and the counts of a checked boundary.
void expect_solid(const Solid& s, const Rational& expected_volume, std::size_t vertices, std::size_t edges,
                  std::size_t faces, std::size_t loops, std::size_t shells) {
  const TopologyCounts counts = count_topology(s.boundary());
  EXPECT_EQ(volume_of(s), expected_volume);
  EXPECT_EQ(counts.vertices, vertices);
  EXPECT_EQ(counts.edges, edges);
  EXPECT_EQ(counts.faces, faces);
  EXPECT_EQ(counts.loops, loops);
  EXPECT_EQ(s.boundary().shells.size(), shells);
  for (const std::string& violation : check_boundary(s.boundary(), 10, one_thread)) ADD_FAILURE() << violation;
}

void expect_valid(const Solid& s) {
  for (const std::string& violation : check_boundary(s.boundary(), 10, one_thread)) ADD_FAILURE() << violation;
}

// Digest of chapters 1 to 4, E24.
TEST(Solid, PenetratingBoxes) {
  const Solid a = box({0, 0, 0}, {4, 4, 4});
  const Solid b = box({1, 1, 3}, {2, 2, 6});
  expect_solid(intersect_two(a, b), Rational(1), 8, 12, 6, 6, 1);
  expect_solid(unite_two(a, b), Rational(66), 16, 24, 11, 12, 1);
  expect_solid(minus(a, b), Rational(63), 16, 24, 11, 12, 1);
  EXPECT_EQ(volume_of(symmetric_difference(std::array{a, b}, one_thread)), Rational(65));
}

// E1: the bracket; with an n-gon for the drill its volume is 64 minus the n-gon's area, exactly that of the rounded
// n-gon.
TEST(Solid, BracketWithFlushHole) {
  const Solid upright = box({0, 0, 0}, {1, 4, 8});
  const Solid plate = box({1, 0, 0}, {9, 4, 1});
  const Mesh drill_mesh = shapes::translated(shapes::prism(48, 1, 1), {5, 2, 0});
  const Solid drill = solid(drill_mesh);
  const Solid bracket = minus(unite_two(upright, plate), drill);
  expect_solid(bracket, Rational(64) - volume_of(drill), 12 + 2 * 48, 18 + 3 * 48, 8 + 48, 10 + 48, 1);
}

// E7, E15: what touches without overlapping.
TEST(Solid, CubesThatShareAFaceAnEdgeAVertex) {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  expect_solid(unite_two(a, box({1, 0, 0}, {2, 1, 1})), Rational(2), 8, 12, 6, 6, 1);
  const Solid edge = unite_two(a, box({1, 1, 0}, {2, 2, 1}));
  expect_solid(edge, Rational(2), 14, 23, 12, 12, 2);
  EXPECT_EQ(count_topology(edge.boundary()).nonmanifold_edges, 1U);
  const Solid vertex = unite_two(a, box({1, 1, 1}, {2, 2, 2}));
  expect_solid(vertex, Rational(2), 15, 24, 12, 12, 2);
  EXPECT_EQ(count_topology(vertex.boundary()).nonmanifold_vertices, 1U);
  expect_solid(unite_two(a, box({1, 0.25, 0.25}, {2, 2, 0.75})), Rational(1) + Rational(7) / Rational(8), 18, 28, 12,
               12, 1);
  for (const Solid& b : {box({1, 0, 0}, {2, 1, 1}), box({1, 1, 0}, {2, 2, 1}), box({1, 1, 1}, {2, 2, 2})}) {
    EXPECT_TRUE(intersect_two(a, b).is_empty());
    EXPECT_EQ(volume_of(minus(a, b)), Rational(1));
  }
}

TEST(Solid, CubeMinusItselfAndNearlyItself) {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(minus(a, a).is_empty());
  EXPECT_TRUE(minus(a, box({0, 0, 0}, {1, 1, 1})).is_empty());
  expect_solid(unite_two(a, box({0, 0, 0}, {1, 1, 1})), Rational(1), 8, 12, 6, 6, 1);
  const double tiny = 0x1p-50;
  expect_solid(minus(a, box({tiny, 0, 0}, {1 + tiny, 1, 1})), Rational(tiny), 8, 12, 6, 6, 1);
  expect_solid(minus(a, box({0.5, 0.5, 0.5}, {1, 1, 1})), Rational(7) / Rational(8), 14, 21, 9, 9, 1);
}

// E28 and E16.
TEST(Solid, ComplementAndNestedShells) {
  const Solid a = box({0, 0, 0}, {4, 4, 4});
  const Solid inner = box({1, 1, 1}, {2, 2, 2});
  EXPECT_TRUE(intersect_two(a, complement(a, one_thread)).is_empty());
  const Solid everything = unite_two(a, complement(a, one_thread));
  EXPECT_TRUE(everything.boundary().is_unbounded);
  EXPECT_EQ(everything.boundary().face_count(), 0U);
  const Solid hollow = minus(a, inner);
  expect_solid(hollow, Rational(63), 16, 24, 12, 12, 2);
  EXPECT_EQ(hollow.boundary().component_count, 1U);
  EXPECT_EQ(unite_two(hollow, box({1.25, 1.25, 1.25}, {1.5, 1.5, 1.5})).boundary().component_count, 2U);
  expect_solid(intersect_two(a, complement(inner, one_thread)), Rational(63), 16, 24, 12, 12, 2);
  expect_solid(unite_two(a, inner), Rational(64), 8, 12, 6, 6, 1);
}

// E27.
TEST(Solid, InscribedOctahedronAndTetrahedron) {
  const Solid cube = box({-1, -1, -1}, {1, 1, 1});
  const Solid octahedron = solid(shapes::octahedron(1));
  expect_solid(intersect_two(cube, octahedron), Rational(4) / Rational(3), 6, 12, 8, 8, 1);
  const Solid tetrahedron = solid(shapes::tetrahedron(1));
  expect_solid(intersect_two(cube, tetrahedron), Rational(8) / Rational(3), 4, 6, 4, 4, 1);
  expect_solid(minus(cube, tetrahedron), Rational(16) / Rational(3), 8, 18, 16, 16, 4);
}

// The cube [0, 3^level]^3 without all beams, as one expression.
Solid menger_sponge(unsigned level) {
  std::vector<Solid> beams;
  for (const Mesh& beam : shapes::menger_beams(level, 0))
    beams.push_back(Solid::of_leaf(make_leaf(beam, {}, one_thread).leaf));
  const double side = std::pow(3, level);
  return subtract(box({0, 0, 0}, {side, side, side}), beams, one_thread);
}

void expect_menger_sponge(const Solid& sponge, unsigned level) {
  EXPECT_EQ(volume_of(sponge), Rational(std::pow(20, level)));
  const double area = 2 * std::pow(20, level) + 4 * std::pow(8, level);
  EXPECT_NEAR(surface_area(sponge.boundary(), one_thread), area, 1e-9 * area);
}

TEST(Solid, MengerSpongeByOneExpression) {
  for (unsigned level = 1; level <= 3; ++level) {
    const Solid sponge = menger_sponge(level);
    expect_menger_sponge(sponge, level);
    if (level < 3) expect_valid(sponge);
  }
}

TEST(Solid, MengerSpongeOfLevelFour) {
  if (tests_take_fewer_rounds) GTEST_SKIP() << "level three is run by another test";
  expect_menger_sponge(menger_sponge(4), 4);
}

// volume(A u B) + volume(A n B) = volume(A) + volume(B), and A - B = A n not B, as rationals.
void expect_inclusion_exclusion(const Solid& a, const Solid& b) {
  const Rational sum = volume_of(a) + volume_of(b);
  const Rational common = volume_of(intersect_two(a, b));
  EXPECT_EQ(volume_of(unite_two(a, b)) + common, sum);
  EXPECT_EQ(volume_of(minus(a, b)), volume_of(a) - common);
  EXPECT_EQ(volume_of(intersect_two(a, complement(b, one_thread))), volume_of(a) - common);
  EXPECT_EQ(volume_of(symmetric_difference(std::array{a, b}, one_thread)), sum - Rational(2) * common);
}

TEST(Solid, InclusionExclusionIsExact) {
  const Solid sphere = solid(shapes::geodesic_sphere(3));
  expect_inclusion_exclusion(sphere, solid(shapes::translated(shapes::geodesic_sphere(3), {0.5, 0.1, 0.2})));
  expect_inclusion_exclusion(sphere, solid(shapes::rotated(shapes::cube(1), shapes::Axis::z, 0.3)));
  const Solid torus = solid(shapes::torus(9, 7, 2, 0.7));
  expect_inclusion_exclusion(torus, solid(shapes::translated(shapes::torus(9, 7, 2, 0.7), {2, 0, 0})));
  expect_inclusion_exclusion(torus, solid(shapes::pointing_along(shapes::torus(9, 7, 2, 0.7), shapes::Axis::x)));
}

// The caps of all cubes lie in two planes. The union is the section by any plane between them, two high; in one
// expression or by halves, in any order.
TEST(Solid, CubesTurnedAboutACommonAxis) {
  for (const int count : {2, 3, 7, 11, 25, 50}) {
    if (tests_take_fewer_rounds && count > 11) break;
    SCOPED_TRACE(count);
    std::vector<Solid> cubes;
    for (int i = 0; i < count; ++i) {
      const Mesh cube = shapes::box({-1, -1, -1}, {1, 1, 1});
      cubes.push_back(solid(shapes::rotated(cube, shapes::Axis::z, 1.5 * i / count)));
    }
    const Solid all = unite(cubes, one_thread);
    expect_valid(all);
    EXPECT_EQ(all.boundary().shells.size(), 1U);
    EXPECT_EQ(volume_of(all), Rational(2) * area_vector(section(all.boundary(), {{0, 0, 1}, 0}, one_thread)).z);
    const std::size_t half = cubes.size() / 2;
    const Solid first = unite(std::span(cubes).first(half), one_thread);
    const Solid second = unite(std::span(cubes).subspan(half), one_thread);
    EXPECT_EQ(volume_of(unite_two(second, first)), volume_of(all));
    EXPECT_EQ(volume_of(first) + volume_of(second) - volume_of(intersect_two(first, second)), volume_of(all));
    const Triangulated triangles = triangulate_boundary(all.boundary(), {}, one_thread);
    EXPECT_EQ(triangles.rounding, Rounding::certified);
  }
}

// Two hundred boxes on a grid of twelve in one union, against a count of its cells.
TEST(Solid, TwoHundredBoxesWithCoincidentPlanes) {
  std::mt19937_64 random(17);
  std::vector<Solid> boxes;
  std::array<std::array<std::array<bool, 12>, 12>, 12> filled{};
  while (boxes.size() < 200) {
    std::array<std::size_t, 3> lo{};
    std::array<std::size_t, 3> hi{};
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = random() % 11;
      hi[k] = std::min<std::size_t>(12, lo[k] + 1 + random() % 3);
    }
    const auto corner = [](const auto& p) {
      return Point3{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    };
    boxes.push_back(box(corner(lo), corner(hi)));
    for (std::size_t x = lo[0]; x < hi[0]; ++x) {
      for (std::size_t y = lo[1]; y < hi[1]; ++y) {
        for (std::size_t z = lo[2]; z < hi[2]; ++z) filled[x][y][z] = true;
      }
    }
  }
  std::int64_t cells = 0;
  for (const auto& layer : filled) {
    for (const auto& row : layer) cells += std::count(row.begin(), row.end(), true);
  }
  const Solid all = unite(boxes, one_thread);
  EXPECT_EQ(volume_of(all), Rational(cells));
  expect_valid(all);
  const Solid first = unite(std::span(boxes).first(100), one_thread);
  const Solid second = unite(std::span(boxes).subspan(100), one_thread);
  EXPECT_EQ(volume_of(first) + volume_of(second) - volume_of(intersect_two(first, second)), Rational(cells));
}

// Boxes on a small grid, so that most planes coincide: volume against a count of unit cells.
TEST(Solid, RandomBoxesAgainstCellCounts) {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<int> coordinate(0, 4);
  for (int repeat = 0; repeat < 40; ++repeat) {
    struct Box {
      std::array<int, 3> lo;
      std::array<int, 3> hi;
    };
    std::vector<Box> boxes;
    std::vector<Solid> solids;
    while (boxes.size() < 5) {
      Box b;
      bool flat = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const int p = coordinate(random);
        const int q = coordinate(random);
        b.lo[k] = std::min(p, q);
        b.hi[k] = std::max(p, q);
        flat = flat || p == q;
      }
      if (flat) continue;
      boxes.push_back(b);
      const auto corner = [](const std::array<int, 3>& c) { return Point3{double(c[0]), double(c[1]), double(c[2])}; };
      solids.push_back(box(corner(b.lo), corner(b.hi)));
    }
    int expected_union = 0;
    int expected_odd = 0;
    int expected_mixed = 0;  // (0 - 1) | (2 & 3) | 4
    for (int x = 0; x < 4; ++x) {
      for (int y = 0; y < 4; ++y) {
        for (int z = 0; z < 4; ++z) {
          std::array<bool, 5> in{};
          int count = 0;
          for (std::size_t i = 0; i < 5; ++i) {
            const Box& b = boxes[i];
            in[i] = b.lo[0] <= x && x < b.hi[0] && b.lo[1] <= y && y < b.hi[1] && b.lo[2] <= z && z < b.hi[2];
            count += in[i] ? 1 : 0;
          }
          expected_union += count > 0 ? 1 : 0;
          expected_odd += count % 2;
          expected_mixed += (in[0] && !in[1]) || (in[2] && in[3]) || in[4] ? 1 : 0;
        }
      }
    }
    SCOPED_TRACE(::testing::Message() << "repeat " << repeat);
    const Solid all = unite(solids, one_thread);
    EXPECT_EQ(volume_of(all), Rational(expected_union));
    expect_valid(all);
    EXPECT_EQ(volume_of(symmetric_difference(solids, one_thread)), Rational(expected_odd));
    const Expression e[] = {Expression::leaf(0), Expression::leaf(1), Expression::leaf(2), Expression::leaf(3),
                            Expression::leaf(4)};
    const Expression parts[] = {Expression::subtract(e[0], {&e[1], 1}),
                                Expression::intersect(std::span(e).subspan(2, 2)), e[4]};
    const Solid mixed = Solid::evaluate(Expression::unite(parts), solids, one_thread);
    EXPECT_EQ(volume_of(mixed), Rational(expected_mixed));
    expect_valid(mixed);
  }
}

// A Boolean of Booleans is one overlay of the inputs: depth loses nothing.
TEST(Solid, ChainOfOperations) {
  Solid result = box({0, 0, 0}, {200, 1, 1});
  for (int i = 0; i < 100; ++i) {
    const Solid tool = box({2.0 * i, 0.25, -1}, {2.0 * i + 1, 0.75, 2});
    result = i % 2 == 0 ? minus(result, tool) : unite_two(result, tool);
  }
  EXPECT_EQ(volume_of(result), Rational(200) - Rational(50) * Rational(0.5) + Rational(50));
  expect_valid(result);
}

std::string bytes_of(const Solid& s, const Context& context) {
  std::ostringstream out;
  write_exact_text(out, s.boundary());
  const Triangulated t = triangulate_boundary(s.boundary(), {}, context);
  for (const Point3& p : t.vertices) out << std::hexfloat << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (const Tile& tile : t.triangles) out << tile[0] << ' ' << tile[1] << ' ' << tile[2] << '\n';
  return out.str();
}

TEST(Solid, DeterministicOnAnyNumberOfThreads) {
  std::string expected;
  for (const unsigned threads : {1U, 2U, 4U}) {
    const Context context({.threads = threads});
    std::vector<Solid> solids;
    for (const Vector3& by : {Vector3{0, 0, 0}, Vector3{0.4, 0.3, 0.1}, Vector3{-0.3, 0.5, 0.2}}) {
      solids.push_back(
          Solid::of_leaf(make_leaf(shapes::translated(shapes::geodesic_sphere(12), by), {}, context).leaf));
    }
    const std::string bytes = bytes_of(unite(solids, context), context);
    if (expected.empty()) expected = bytes;
    EXPECT_EQ(bytes, expected) << threads << " threads";
  }
}

TEST(Solid, ScalingByPowersOfTwoChangesNothing) {
  const auto result = [](double scale) {
    const auto scaled = [&](const Mesh& mesh) { return solid(shapes::scaled(mesh, {scale, scale, scale})); };
    return minus(scaled(shapes::geodesic_sphere(2)), scaled(shapes::rotated(shapes::cube(0.9), shapes::Axis::x, 0.4)));
  };
  const Solid expected = result(1);
  for (const int exponent : {-900, -300, -1, 60, 300, 900}) {
    SCOPED_TRACE(exponent);
    const Solid scaled = result(std::ldexp(1.0, exponent));
    Rational cubic(1);
    for (int i = 0; i < 3; ++i) cubic *= Rational(std::ldexp(1.0, exponent));
    const TopologyCounts counts = count_topology(expected.boundary());
    expect_solid(scaled, volume_of(expected) * cubic, counts.vertices, counts.edges, counts.faces, counts.loops, 1);
  }
}

TEST(Solid, SelfCrossingInputMeansItsPositiveWinding) {
  // Two overlapping cubes in one mesh: winding 2 where they overlap.
  const Mesh both = shapes::joined({shapes::box({0, 0, 0}, {2, 2, 2}), shapes::box({1, 1, 1}, {3, 3, 3})});
  const LeafResult leaf = make_leaf(both, {}, one_thread);
  ASSERT_NE(leaf.leaf, nullptr);
  EXPECT_GT(leaf.diagnosis.crossing_faces.count, 0U);
  expect_solid(Solid::from_leaf(leaf.leaf, one_thread), Rational(15), 20, 30, 12, 12, 1);
  // A cube inside out has no positive winding.
  EXPECT_TRUE(solid(shapes::reversed(shapes::cube())).is_empty());
}

TEST(Solid, OpenMeshesAreDiagnosed) {
  Mesh mesh = shapes::cube();
  mesh.face_begin.pop_back();
  mesh.corners.resize(mesh.face_begin.back());
  const LeafResult result = make_leaf(mesh, {}, one_thread);
  EXPECT_EQ(result.leaf, nullptr);
  EXPECT_EQ(result.diagnosis.open_edges.count, 4U);
}

TEST(Solid, ExactTextComesBackWithoutLoss) {
  const Solid s =
      minus(solid(shapes::geodesic_sphere(2)), solid(shapes::rotated(shapes::cube(0.9), shapes::Axis::x, 0.4)));
  std::ostringstream out;
  write_exact_text(out, s.boundary());
  const Brep read = read_exact_text(out.str(), "a.qsolid");
  std::ostringstream again;
  write_exact_text(again, read);
  EXPECT_EQ(again.str(), out.str());
  EXPECT_EQ(volume(read, one_thread), volume_of(s));
  EXPECT_TRUE(check_boundary(read, 10, one_thread).empty());
  EXPECT_THROW(read_exact_text(out.str().substr(0, out.str().size() / 2), "a.qsolid"), InputError);
}

TEST(Solid, CancellationLeavesInputsUsable) {
  const Solid a = solid(shapes::geodesic_sphere(8));
  const Solid b = solid(shapes::translated(shapes::geodesic_sphere(8), {0.5, 0, 0}));
  Context cancelled({.threads = 2});
  cancelled.cancel();
  EXPECT_THROW(unite(std::array{a, b}, cancelled), Cancelled);
  expect_valid(unite_two(a, b));
}

// From whichever stage reports first to the last, and the same inputs give the same result afterwards.
TEST(Solid, CancellationAtEveryStage) {
  const Mesh a = shapes::geodesic_sphere(8);
  const Mesh b = shapes::translated(shapes::geodesic_sphere(8), {0.5, 0.25, 0.125});
  const auto run = [&](const Context& context) {
    const std::array<Solid, 2> solids{Solid::of_leaf(make_leaf(a, {}, context).leaf),
                                      Solid::of_leaf(make_leaf(b, {}, context).leaf)};
    return triangulate_boundary(unite(solids, context).boundary(), {}, context).triangles;
  };
  int reports = 0;
  const std::vector<Tile> expected =
      run(Context({.threads = 2, .progress = [&](std::string_view, double) { ++reports; }}));
  ASSERT_GT(reports, 5);
  for (int last = 1; last <= reports; ++last) {
    int seen = 0;
    Context* running = nullptr;
    Context context({.threads = 2, .progress = [&](std::string_view, double) {
                       if (++seen == last) running->cancel();
                     }});
    running = &context;
    EXPECT_THROW(run(context), Cancelled) << "report " << last;
  }
  EXPECT_EQ(run(one_thread), expected);
}

TEST(Solid, BoxesAtTheEndsOfTheRange) {
  for (const int exponent : {-1070, -800, 800, 1019}) {
    const double unit = std::ldexp(1.0, exponent);
    const auto at = [&](double x, double y, double z) { return Point3{unit * x, unit * y, unit * z}; };
    Rational cubic(1);
    for (int i = 0; i < 3; ++i) cubic *= Rational(unit);
    SCOPED_TRACE(exponent);
    const Solid a = box(at(0, 0, 0), at(4, 4, 4));
    expect_solid(minus(a, box(at(1, 1, 0), at(2, 2, 4))), Rational(60) * cubic, 16, 24, 10, 12, 1);
    expect_solid(unite_two(a, box(at(4, 0, 0), at(8, 4, 4))), Rational(128) * cubic, 8, 12, 6, 6, 1);
    expect_solid(minus(a, box(at(1, 1, 1), at(2, 2, 2))), Rational(63) * cubic, 16, 24, 12, 12, 2);
  }
}

TEST(Solid, OperandsThatWereNotEvaluatedSaySo) {
  const Solid operand = Solid::of_leaf(make_leaf(shapes::cube(), {}, one_thread).leaf);
  EXPECT_THROW(operand.boundary(), Error);
  EXPECT_THROW(static_cast<void>(operand.is_empty()), Error);
  EXPECT_EQ(volume_of(unite({&operand, 1}, one_thread)), Rational(1));
}

TEST(Solid, ExactTextKeepsNamesAndColors) {
  Mesh mesh = shapes::cube();
  mesh.name = "a  name # with 100% of \t everything";
  for (std::uint8_t f = 0; f < 6; ++f) mesh.face_colors.push_back({f, 2, 3, 255});
  const Solid s = solid(mesh);
  std::ostringstream out;
  write_exact_text(out, s.boundary());
  const Brep read = read_exact_text(out.str(), "a.qsolid");
  EXPECT_EQ(read.leaf_names, s.boundary().leaf_names);
  EXPECT_EQ(read.face_colors, s.boundary().face_colors);
  EXPECT_EQ(read.face_colors.size(), 6U);
}

TEST(Exit, CoordinatesBeyondThePrecisionAreRefused) {
  ExitOptions options;
  options.precision = Precision::binary32;
  EXPECT_THROW(triangulate_boundary(box({0, 0, 0}, {1e39, 1, 1}).boundary(), options, one_thread), InputError);
}

TEST(Exit, UnboundedSetsKeepTheirBoundary) {
  for (const double angle : {1e-13, 1e-15}) {
    std::vector<Solid> cubes;
    for (int i = 0; i < 3; ++i) {
      cubes.push_back(
          solid(shapes::rotated(shapes::box({-1, -1, -1}, {1, 1, 1}), static_cast<shapes::Axis>(i), angle * (i + 1))));
    }
    const Solid outside = complement(unite(cubes, one_thread), one_thread);
    const Triangulated t = triangulate_boundary(outside.boundary(), {}, one_thread);
    SCOPED_TRACE(::testing::Message() << "angle " << angle << " rounds " << t.rounds);
    Mesh mesh;
    mesh.vertices = t.vertices;
    for (const Tile& tile : t.triangles) mesh.add_face(tile);
    const LeafResult leaf = make_leaf(shapes::reversed(mesh), {}, one_thread);
    ASSERT_NE(leaf.leaf, nullptr);
    EXPECT_NEAR(rounded_volume(Solid::from_leaf(leaf.leaf, one_thread).boundary(), one_thread), 8, 1e-6);
  }
}

TEST(Exit, BothPrecisionsAreCertifiedAndClosed) {
  const Solid s = unite_two(solid(shapes::geodesic_sphere(6)),
                            solid(shapes::translated(shapes::geodesic_sphere(6), {0.5, 0.1, 0.2})));
  for (const Precision precision : {Precision::binary64, Precision::binary32}) {
    ExitOptions options;
    options.precision = precision;
    const Triangulated t = triangulate_boundary(s.boundary(), options, one_thread);
    EXPECT_EQ(t.rounding, Rounding::certified);
    EXPECT_GT(t.max_displacement, 0);
    EXPECT_LT(t.max_displacement, precision == Precision::binary64 ? 1e-15 : 1e-7);
    Mesh mesh;
    mesh.vertices = t.vertices;
    for (const Tile& tile : t.triangles) mesh.add_face(tile);
    const LeafResult leaf = make_leaf(mesh, {}, one_thread);  // settles crossings again
    ASSERT_NE(leaf.leaf, nullptr);
    EXPECT_FALSE(leaf.leaf->crosses_itself);
    EXPECT_NEAR(rounded_volume(Solid::from_leaf(leaf.leaf, one_thread).boundary(), one_thread),
                rounded_volume(s.boundary(), one_thread), 1e-5);
  }
}

// Cubes turned by tiny angles: features far thinner than the spacing of doubles need rounds of snapping. Whatever comes
// out must be closed, and free of crossings to a check that starts from nothing.
TEST(Exit, NearlyCoincidentCubesAreSnappedUntilNothingCrosses) {
  std::size_t snapped = 0;
  for (const bool is_union : {true, false}) {
    for (const double angle : {1e-5, 1e-9, 1e-13, 3e-16}) {
      std::vector<Solid> cubes;
      for (int i = 0; i < (tests_take_fewer_rounds ? 4 : 8); ++i) {
        Mesh mesh = shapes::box({-1, -1, -1}, {1, 1, 1});
        for (int k = 0; k < 3; ++k)
          mesh = shapes::rotated(mesh, static_cast<shapes::Axis>(k), angle * ((i * 7 + k * 3) % 11 - 5));
        cubes.push_back(Solid::of_leaf(make_leaf(mesh, {}, one_thread).leaf));
      }
      const Solid s = is_union ? unite(cubes, one_thread) : intersect(cubes, one_thread);
      expect_valid(s);
      const Triangulated t = triangulate_boundary(s.boundary(), {}, one_thread);
      SCOPED_TRACE(::testing::Message() << "angle " << angle << " union " << is_union << " rounds " << t.rounds);
      ASSERT_LE(t.rounding, Rounding::changed);
      snapped += t.rounds > 0 ? 1 : 0;
      Mesh mesh;
      mesh.vertices = t.vertices;
      for (const Tile& tile : t.triangles) mesh.add_face(tile);
      const LeafResult leaf = make_leaf(mesh, {}, one_thread);
      ASSERT_NE(leaf.leaf, nullptr);
      EXPECT_EQ(leaf.diagnosis.crossing_faces.count, 0U);
      EXPECT_EQ(leaf.diagnosis.degenerate_faces.count, 0U);
      const Solid back = Solid::from_leaf(leaf.leaf, one_thread);
      EXPECT_NEAR(rounded_volume(back.boundary(), one_thread), rounded_volume(s.boundary(), one_thread),
                  24 * t.max_displacement);
      const bool has_same_parts = topology_of(back.boundary()).has_parts_of(topology_of(s.boundary()));
      EXPECT_EQ(t.rounding <= Rounding::certified, has_same_parts);
      if (t.rounds > 0) {
        EXPECT_EQ(t.topology_after, topology_of(back.boundary()));
      }
    }
  }
  EXPECT_GT(snapped, test_cases(4U));
}

}  // namespace
}  // namespace quoin
