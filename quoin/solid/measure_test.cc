// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "quoin/kernel/test_points.h"
#include "quoin/number/test_doubles.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"

namespace quoin {
namespace {

using shapes::Axis;
using testing::Random;

const Context one_thread({.threads = 1});
constexpr double infinity = std::numeric_limits<double>::infinity();

Rational two_to(int exponent) {
  const Integer power = Integer(1) << static_cast<std::size_t>(std::abs(exponent));
  return exponent < 0 ? Rational(Integer(1), power) : Rational(power);
}

// Signed volume of a tetrahedron and its first moments.
struct SlowVolume {
  Rational volume;
  RationalPoint3 moment{0, 0, 0};
};

void add_tetrahedron(SlowVolume& sum, const std::array<RationalPoint3, 4>& p) {
  testing::Matrix rows;
  for (std::size_t i = 1; i < 4; ++i) {
    const RationalPoint3 d = p[i] - p[0];
    rows.push_back({d.x, d.y, d.z});
  }
  const Rational volume = testing::determinant(rows) / Rational(6);
  sum.volume += volume;
  sum.moment = sum.moment + (p[0] + p[1] + p[2] + p[3]) * (volume / Rational(4));
}

// Of a closed boundary: tetrahedra between a point anywhere, here about as far away as the boundary is large, and the
// triangles between the last vertex of each loop and its edges.
SlowVolume slow_volume(const Brep& b) {
  double size = 0;
  for (std::size_t p = 0; p < b.points.point_count(); ++p) {
    for (std::size_t k = 0; k < 3; ++k) size = std::max(size, std::fabs(b.points.rounded(PointId{p})[k]));
  }
  const RationalPoint3 direction{Rational(3) / Rational(7), Rational(-5) / Rational(11), Rational(2) / Rational(13)};
  const RationalPoint3 far = direction * (size == 0 ? Rational(1) : two_to(std::ilogb(size)));
  SlowVolume sum;
  for (std::size_t l = 0; l < b.loop_count(); ++l) {
    const auto loop = b.loop(l);
    const RationalPoint3 last = b.points.exact(loop.back());
    for (std::size_t i = 0; i + 2 < loop.size(); ++i) {
      add_tetrahedron(sum, {far, last, b.points.exact(loop[i]), b.points.exact(loop[i + 1])});
    }
  }
  return sum;
}

struct SlowArea {
  RationalPoint3 normal;
  Rational square;  // of the area
};

// The shoelace formula along an axis that the normal of the face's plane has a component along, over the square of the
// cosine between the two. The plane is that of `face_planes`, not of the loops.
SlowArea slow_area(const Brep& b, std::uint32_t face) {
  const auto& plane = b.face_planes[face];
  const RationalPoint3 a = b.points.exact(plane[0]);
  const RationalPoint3 n = cross(b.points.exact(plane[1]) - a, b.points.exact(plane[2]) - a);
  const unsigned axis = n.x.sign() != Sign::zero ? 0 : n.y.sign() != Sign::zero ? 1 : 2;
  if (n[axis].sign() == Sign::zero) return {n, Rational(0)};  // the corners of a triangle lie on a line
  Rational twice;
  for (std::uint32_t l = b.face_first_loop[face]; l < b.face_first_loop[face + 1]; ++l) {
    const auto loop = b.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RationalPoint3 p = b.points.exact(loop[i]);
      const RationalPoint3 q = b.points.exact(loop[(i + 1) % loop.size()]);
      twice += p[(axis + 1) % 3] * q[(axis + 2) % 3] - p[(axis + 2) % 3] * q[(axis + 1) % 3];
    }
  }
  EXPECT_EQ(twice.sign() * n[axis].sign(), Sign::positive) << "face " << face;
  return {n, twice * twice * dot(n, n) / (Rational(4) * n[axis] * n[axis])};
}

// Below the square root by less than 2^-256 of a unit in the last place of the fraction.
Rational root(const Rational& square) {
  const Integer denominator = square.denominator();
  Integer r = (square.numerator() * denominator) << 512;
  mpz_sqrt(r.raw(), r.raw());
  return Rational(r, denominator << 256);
}

// The definition of rounding to nearest: the value lies between the middles towards the neighbours, and on one of them
// only if the double is the even one. Infinity stands for 2^1024.
bool is_nearest(double d, const Rational& value) {
  const auto place = [](double x) { return std::isinf(x) ? two_to(1024) * Rational(x > 0 ? 1 : -1) : Rational(x); };
  const auto middle = [&](double other) { return (place(d) + place(other)) / Rational(2); };
  const bool is_even = (std::bit_cast<std::uint64_t>(d) & 1) == 0;
  const auto lies_above = [&](const Rational& m) { return m < value || (is_even && m == value); };
  const auto lies_below = [&](const Rational& m) { return value < m || (is_even && m == value); };
  return (d == -infinity || lies_above(middle(std::nextafter(d, -infinity)))) &&
         (d == infinity || lies_below(middle(std::nextafter(d, infinity))));
}

void expect_areas(const Brep& b) {
  Rational total;
  for (std::uint32_t f = 0; f < b.face_count(); ++f) {
    const SlowArea expected = slow_area(b, f);
    const RationalPoint3 v = area_vector(b, f);
    EXPECT_EQ(dot(v, v), expected.square) << "face " << f;
    EXPECT_EQ(cross(v, expected.normal), (RationalPoint3{0, 0, 0})) << "face " << f;
    EXPECT_GE(dot(v, expected.normal).sign(), Sign::zero) << "face " << f;
    total += root(expected.square);
  }
  // 2^-51 of each length, half a unit of each sum; two units of subnormal lengths.
  const double area = surface_area(b, one_thread);
  const auto faces = static_cast<std::int64_t>(b.face_count());
  const Rational error = total * Rational(4 + faces) * two_to(-53) + Rational(2 * faces) * two_to(-1074);
  if (std::isinf(area)) {
    EXPECT_GT(total + error, Rational(std::numeric_limits<double>::max()));
  } else {
    EXPECT_LE(abs(Rational(area) - total), error) << area;
  }
}

void expect_bounds(const Brep& b) {
  const std::optional<Bounds> box = bounds(b);
  ASSERT_EQ(box.has_value(), b.face_count() > 0);
  if (!box) return;
  for (unsigned axis = 0; axis < 3; ++axis) {
    Rational lo = b.points.exact(b.loop_vertices[0])[axis];
    Rational hi = lo;
    for (const PointId p : b.loop_vertices) {
      lo = std::min(lo, b.points.exact(p)[axis]);
      hi = std::max(hi, b.points.exact(p)[axis]);
    }
    EXPECT_TRUE(is_nearest(box->lo[axis], lo)) << box->lo[axis];
    EXPECT_TRUE(is_nearest(box->hi[axis], hi)) << box->hi[axis];
  }
}

// Everything that is measured against its slow definition. Returns the volume.
Rational expect_measures(const Brep& b) {
  const SlowVolume expected = slow_volume(b);
  EXPECT_EQ(volume(b, one_thread), expected.volume);
  const double rounded = rounded_volume(b, one_thread);
  EXPECT_TRUE(is_nearest(rounded, expected.volume)) << rounded;
  const std::optional<RationalPoint3> centre = centroid(b, one_thread);
  EXPECT_EQ(centre.has_value(), expected.volume.sign() != Sign::zero);
  if (centre) {
    EXPECT_EQ(*centre * expected.volume, expected.moment);
  }
  expect_areas(b);
  expect_bounds(b);
  return expected.volume;
}

Solid solid(const Mesh& mesh) {
  const LeafResult result = make_leaf(mesh, {}, one_thread);
  EXPECT_NE(result.leaf, nullptr);
  return Solid::from_leaf(result.leaf, one_thread);
}

// Measures ask nothing of a boundary but its points and loops: one face per face of the mesh, which may cross others.
template <class Point>
Brep boundary_of(const Mesh& mesh, const std::vector<Point>& vertices) {
  Brep b;
  b.points = Constructions(vertices);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    for (const std::uint32_t c : corners) b.loop_vertices.push_back(PointId{c});
    b.loop_begin.push_back(static_cast<std::uint32_t>(b.loop_vertices.size()));
    b.face_first_loop.push_back(static_cast<std::uint32_t>(b.loop_count()));
    b.face_planes.push_back({PointId{corners[0]}, PointId{corners[1]}, PointId{corners[2]}});
  }
  return b;
}

// Coordinates below 1 that are multiples of 2^-bits and need all of those bits together.
class GridCoordinates {
 public:
  GridCoordinates(int bits, std::uint64_t seed) : bits_(bits), width_(std::min(bits, 53)), random_(seed) {}

  double largest() const { return 1 - std::ldexp(1.0, -width_); }
  double smallest() const { return std::ldexp(1.0, -bits_); }

  // The ends of the range, and windows of bits anywhere in it.
  double any() {
    const double sign = random_() % 2 == 0 ? 1 : -1;
    switch (random_() % 6) {
      case 0:
      case 1:
        return sign * largest();
      case 2:
        return sign * smallest();
      default:
        break;
    }
    const int width = std::uniform_int_distribution<int>(1, width_)(random_);
    const int shift = std::uniform_int_distribution<int>(0, bits_ - width)(random_);
    return sign * std::ldexp(static_cast<double>(random_() >> (64 - width)), shift - bits_);
  }

  std::vector<Point3> points(std::size_t count) {
    std::vector<Point3> result(count);
    for (Point3& p : result) p = {any(), any(), any()};
    result[0].x = largest();
    result[1].y = smallest();
    return result;
  }

 private:
  int bits_;
  int width_;
  Random random_;
};

struct Limit {
  int bits;
  GridClass grid_class;
};
constexpr Limit limits[] = {{30, GridClass::bits30},  {31, GridClass::bits61},   {61, GridClass::bits61},
                            {62, GridClass::bits124}, {123, GridClass::bits124}, {124, GridClass::bits124},
                            {125, GridClass::big},    {126, GridClass::big},     {700, GridClass::big}};

// From the smallest double to the largest one: where the grid ends below or above the range of doubles is left out.
std::vector<int> exponents_for(int bits) {
  std::vector<int> result;
  for (const int exponent : {bits - 1074, -900, -331, 0, 1, 331, 900, 1024}) {
    if (exponent - bits >= -1074) result.push_back(exponent);
  }
  return result;
}

std::vector<Point3> times_two_to(std::vector<Point3> points, int exponent) {
  for (Point3& p : points) {
    for (std::size_t k = 0; k < 3; ++k) p[k] = std::ldexp(p[k], exponent);
  }
  return points;
}

TEST(Measure, TrianglesAtTheLimitsOfEveryGridClass) {
  const Mesh surfaces[] = {shapes::tetrahedron(), shapes::octahedron(), shapes::geodesic_sphere(2)};
  for (const auto& [bits, grid_class] : limits) {
    for (std::uint64_t seed = 0; seed < 9; ++seed) {
      const Mesh& surface = surfaces[seed % 3];
      const std::vector<Point3> points = GridCoordinates(bits, seed).points(surface.vertices.size());
      std::optional<Rational> unscaled;
      for (const int exponent : exponents_for(bits)) {
        if (seed >= 3 && exponent != 0) continue;
        SCOPED_TRACE(::testing::Message() << bits << " bits, seed " << seed << ", exponent " << exponent);
        const Brep b = boundary_of(surface, times_two_to(points, exponent));
        ASSERT_EQ(b.points.grid_class(), grid_class);
        const Rational here = expect_measures(b) / two_to(3 * exponent);
        EXPECT_EQ(here, unscaled.value_or(here));
        unscaled = here;
      }
    }
  }
}

// Sums of three products of the largest coordinates with signs that add up: 4 times their cube for each determinant.
TEST(Measure, LargestDeterminants) {
  const Mesh surface = shapes::tetrahedron();
  const std::vector<Point3> signs{{1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, -1}};
  for (const auto& [bits, grid_class] : limits) {
    SCOPED_TRACE(bits);
    const GridCoordinates grid(bits, 0);
    const auto corner = [&](std::size_t i) {
      return Point3{signs[i].x * grid.largest(), signs[i].y * grid.largest(), signs[i].z * grid.largest()};
    };
    std::vector<Point3> points{corner(0), corner(1), corner(2), corner(3), {0, 0, grid.smallest()}};
    for (const bool is_mirrored : {false, true}) {
      const Brep b = boundary_of(surface, points);
      ASSERT_EQ(b.points.grid_class(), grid_class);
      const Rational largest(grid.largest());
      EXPECT_EQ(abs(expect_measures(b)), Rational(8) / Rational(3) * largest * largest * largest) << is_mirrored;
      std::swap(points[0], points[1]);
    }
  }
}

// A face of more than three corners, and solids that went through the overlay.
TEST(Measure, BoxesHaveTheProductOfTheirSides) {
  for (const auto& [bits, grid_class] : limits) {
    GridCoordinates grid(bits, 5);
    for (const int exponent : exponents_for(bits)) {
      SCOPED_TRACE(::testing::Message() << bits << " bits, exponent " << exponent);
      std::vector<Point3> corners{{-grid.largest(), -grid.smallest(), grid.any()},
                                  {grid.smallest(), grid.largest(), 0}};
      while (corners[1].z == 0 || corners[1].z == corners[0].z) corners[1].z = grid.any();
      if (corners[1].z < corners[0].z) std::swap(corners[0].z, corners[1].z);
      corners = times_two_to(corners, exponent);
      const Solid box = solid(shapes::box(corners[0], corners[1]));
      ASSERT_EQ(box.boundary().points.grid_class(), grid_class);
      const RationalPoint3 sides = exact_point(corners[1]) - exact_point(corners[0]);
      EXPECT_EQ(expect_measures(box.boundary()), sides.x * sides.y * sides.z);
    }
  }
}

// Which kinds of boundaries the tests below have met.
struct Met {
  std::set<GridClass> classes;
  std::size_t explicit_faces = 0;
  std::size_t constructed_faces = 0;
  std::size_t mixed_faces = 0;

  void count(const Brep& b) {
    classes.insert(b.points.grid_class());
    for (std::uint32_t f = 0; f < b.face_count(); ++f) {
      std::array<std::size_t, 2> vertices{};
      for (std::uint32_t l = b.face_first_loop[f]; l < b.face_first_loop[f + 1]; ++l) {
        for (const PointId p : b.loop(l)) ++vertices[p.index() < b.points.explicit_count() ? 0 : 1];
      }
      (vertices[1] == 0 ? explicit_faces : vertices[0] == 0 ? constructed_faces : mixed_faces) += 1;
    }
  }
};

// All Booleans of two solids, and of what is left out.
void expect_booleans(const Mesh& first, const Mesh& second, int exponent, Met& met) {
  const double factor = std::ldexp(1.0, exponent);
  const std::array<Solid, 2> both{solid(shapes::scaled(first, {factor, factor, factor})),
                                  solid(shapes::scaled(second, {factor, factor, factor}))};
  const auto measured = [&](const Solid& s) {
    met.count(s.boundary());
    return expect_measures(s.boundary());
  };
  const Rational sum = measured(both[0]) + measured(both[1]);
  const Solid common = intersect(both, one_thread);
  EXPECT_EQ(measured(unite(both, one_thread)) + measured(common), sum);
  EXPECT_EQ(measured(symmetric_difference(both, one_thread)), sum - Rational(2) * measured(common));
  const Solid rest = subtract(both[0], {&both[1], 1}, one_thread);
  const Solid outside = complement(rest, one_thread);
  EXPECT_TRUE(outside.boundary().is_unbounded);
  EXPECT_EQ(measured(outside), -measured(rest));
  EXPECT_EQ(centroid(outside.boundary(), one_thread), centroid(rest.boundary(), one_thread));
}

TEST(Measure, BooleansOfExplicitAndConstructedVertices) {
  const Mesh cube = shapes::cube(2);
  const Mesh ball = shapes::geodesic_sphere(2);
  const std::pair<Mesh, Mesh> pairs[] = {
      {cube, shapes::translated(shapes::octahedron(2), {1, 0, 1})},                      // integers
      {cube, shapes::translated(shapes::prism(7, 0.5, 3), {1, 1, -0.25})},               // faces with holes
      {cube, shapes::translated(shapes::cube(1), {0.5, 0.5, 2})},                        // touches
      {ball, shapes::rotated(shapes::cube(0.9), Axis::x, 0.4)},                          // 53 bits and more
      {ball, shapes::translated(shapes::rotated(ball, Axis::y, 1), {0.3, 0x1p-60, 0})},  //
      {shapes::torus(5, 4, 2, 0.7), shapes::rotated(shapes::box({-3, -3, -0x1p-90}, {3, 3, 1}), Axis::z, 1e-9)},
      {shapes::rotated(cube, Axis::z, 0.3), shapes::rotated(cube, Axis::x, 1e-40)},            // wider than 124 bits
      {shapes::translated(ball, {1e9, 1e9, 1e9}), shapes::translated(cube, {1e9, 1e9, 1e9})},  // far from the origin
  };
  Met met;
  for (std::size_t i = 0; i < std::size(pairs); ++i) {
    for (const int exponent : {-600, 0, 900}) {
      SCOPED_TRACE(::testing::Message() << "pair " << i << ", exponent " << exponent);
      expect_booleans(pairs[i].first, pairs[i].second, exponent, met);
    }
  }
  EXPECT_EQ(met.classes, (std::set{GridClass::bits30, GridClass::bits61, GridClass::bits124, GridClass::big}));
  EXPECT_GT(met.explicit_faces, 100U);
  EXPECT_GT(met.constructed_faces, 100U);
  EXPECT_GT(met.mixed_faces, 100U);
}

// A tetrahedron cut by a plane through one edge and a third of the opposite one: faces of which one vertex is
// constructed.
TEST(Measure, OneConstructedVertex) {
  Mesh corner;
  corner.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Tile& t : {Tile{0, 2, 1}, Tile{0, 1, 3}, Tile{1, 2, 3}, Tile{2, 0, 3}}) corner.add_face(t);
  Mesh wedge;
  wedge.vertices = {{-4, -8, -1}, {4, 8, -1}, {-8, 8, -1}, {-4, -8, 2}, {4, 8, 2}, {-8, 8, 2}};
  wedge.corners = {2, 1, 0, 3, 4, 5, 0, 1, 4, 3, 1, 2, 5, 4, 2, 0, 3, 5};
  wedge.face_begin = {0, 3, 6, 10, 14, 18};
  const Solid tool = solid(wedge);
  const Solid rest = subtract(solid(corner), {&tool, 1}, one_thread);
  const Brep& b = rest.boundary();
  ASSERT_EQ(b.points.point_count() - b.points.explicit_count(), 1U);
  Met met;
  met.count(b);
  EXPECT_EQ(met.mixed_faces, 3U);
  EXPECT_EQ(expect_measures(b), Rational(1) / Rational(9));
}

// A result has the class of all inputs, of which the points that need most bits may be gone: the smallest or largest.
TEST(Measure, BoundariesOnFewerBitsThanTheirGridClass) {
  const std::pair<int, GridClass> cases[] = {
      {59, GridClass::bits61}, {60, GridClass::bits124}, {122, GridClass::bits124}, {123, GridClass::big}};
  for (const auto& [size, grid_class] : cases) {
    for (const int exponent : {-size, size}) {
      SCOPED_TRACE(exponent);
      const double unit = std::ldexp(1.0, exponent);
      const Solid gone = solid(shapes::box({-2 * unit, 0, 0}, {-unit, unit, unit}));
      const Solid rest = subtract(solid(shapes::cube(3)), {&gone, 1}, one_thread);
      ASSERT_EQ(rest.boundary().points.grid_class(), grid_class);
      EXPECT_EQ(expect_measures(rest.boundary()), Rational(27));
    }
  }
}

TEST(Measure, VerticesThatAreRational) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Mesh surface = shapes::geodesic_sphere(1 + seed % 2);
    std::vector<RationalPoint3> points;
    for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
      const auto coordinate = [&] {
        return Rational(testing::small_integer(random, 1000)) / Rational(1 + static_cast<int>(random() % 99));
      };
      points.push_back({coordinate(), coordinate(), coordinate()});
    }
    const Brep b = boundary_of(surface, points);
    ASSERT_EQ(b.points.grid_class(), GridClass::rational);
    expect_measures(b);
  }
}

TEST(Measure, NothingAndEverything) {
  const Solid nothing;
  const Solid everything = complement(nothing, one_thread);
  EXPECT_TRUE(everything.boundary().is_unbounded);
  for (const Solid& s : {nothing, everything}) {
    EXPECT_EQ(expect_measures(s.boundary()), Rational(0));
    EXPECT_EQ(rounded_volume(s.boundary(), one_thread), 0);
    EXPECT_EQ(centroid(s.boundary(), one_thread), std::nullopt);
    EXPECT_EQ(surface_area(s.boundary(), one_thread), 0);
  }
}

// What cancels: a boundary and its reverse, at every class.
TEST(Measure, VolumesThatVanish) {
  for (const auto& [bits, grid_class] : limits) {
    SCOPED_TRACE(bits);
    Mesh surface = shapes::octahedron();
    surface.vertices = GridCoordinates(bits, 3).points(surface.vertices.size());
    const Mesh both = shapes::joined({surface, shapes::reversed(surface)});
    const Brep b = boundary_of(both, both.vertices);
    EXPECT_EQ(expect_measures(b), Rational(0));
    EXPECT_FALSE(std::signbit(rounded_volume(b, one_thread)));
  }
}

// 2^53 + 1 = 3 * 3002399751580331 and 2^53 + 3 = 5 * 1801439850948199 lie in the middle of two doubles.
TEST(Measure, RoundedVolumeBreaksTiesToEven) {
  for (const int exponent : {-1000, -300, 0, 300}) {
    const double unit = std::ldexp(1.0, exponent);
    const auto rounded = [&](double x, double y) {
      const Solid box = solid(shapes::box({0, 0, 0}, {x, y, unit}));
      expect_measures(box.boundary());
      return rounded_volume(box.boundary(), one_thread) / unit;
    };
    EXPECT_EQ(rounded(3, 3002399751580331), 0x1p53);
    EXPECT_EQ(rounded(5, 1801439850948199), 0x1p53 + 4);
  }
}

// The same volumes over constructed points, of which no enclosure tells the nearest double.
TEST(Measure, RoundedVolumeOfConstructedPointsBreaksTiesToEven) {
  const auto rounded = [&](double x, double y) {
    const std::vector<Solid> boxes{solid(shapes::box({0, 0, -1}, {x, y + 1, 1})),
                                   solid(shapes::box({-1, -1, 0}, {x + 1, y, 2}))};
    const Solid both = intersect(boxes, one_thread);
    EXPECT_GT(both.boundary().points.point_count(), both.boundary().points.explicit_count());
    expect_measures(both.boundary());
    return rounded_volume(both.boundary(), one_thread);
  };
  EXPECT_EQ(rounded(3, 3002399751580331 - 1), 0x1p53 - 2);
  EXPECT_EQ(rounded(3, 3002399751580331), 0x1p53);
  EXPECT_EQ(rounded(5, 1801439850948199), 0x1p53 + 4);
}

TEST(Measure, TheSameOnAnyNumberOfThreads) {
  for (const int bits : {61, 124, 125}) {
    SCOPED_TRACE(bits);
    const Mesh surface = shapes::geodesic_sphere(12);
    const Brep b = boundary_of(surface, GridCoordinates(bits, 1).points(surface.vertices.size()));
    const SlowVolume expected = slow_volume(b);
    for (const unsigned threads : {1U, 2U, 4U}) {
      const Context context({.threads = threads});
      EXPECT_EQ(volume(b, context), expected.volume);
      EXPECT_TRUE(is_nearest(rounded_volume(b, context), expected.volume));
      EXPECT_EQ(centroid(b, context).value() * expected.volume, expected.moment);
      EXPECT_EQ(surface_area(b, context), surface_area(b, one_thread));
    }
  }
}

}  // namespace
}  // namespace quoin
