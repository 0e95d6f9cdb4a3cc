// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/number/rational.h"
#include "quoin/number/test_doubles.h"

/// Families of points for tests of predicates, and determinants by their definition.
namespace quoin::testing {

using Matrix = std::vector<std::vector<Rational>>;

/// By cofactors of the first row.
inline Rational determinant(const Matrix& m) {
  if (m.size() == 1) return m[0][0];
  Rational sum;
  for (std::size_t k = 0; k < m.size(); ++k) {
    Matrix minor;
    for (std::size_t i = 1; i < m.size(); ++i) {
      minor.push_back(m[i]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(k));
    }
    const Rational term = m[0][k] * determinant(minor);
    if (k % 2 == 0) {
      sum += term;
    } else {
      sum -= term;
    }
  }
  return sum;
}

inline std::vector<Rational> coordinates(const Point2& p) {
  return {Rational(p.x), Rational(p.y)};
}
inline std::vector<Rational> coordinates(const Point3& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

/// Row (p, 1) or (p, |p|^2, 1).
template <class Point>
std::vector<Rational> affine_row(const Point& p, bool is_lifted) {
  std::vector<Rational> row = coordinates(p);
  Rational lift;
  for (const Rational& x : row) lift += x * x;
  if (is_lifted) row.push_back(lift);
  row.emplace_back(1);
  return row;
}

/// Determinant of the affine rows: the definitions of orientation and of the circle and sphere tests, up to a sign that
/// depends on the dimension.
template <class Point, std::size_t N>
Sign sign_of_rows(const std::array<Point, N>& points, bool is_lifted) {
  Matrix m;
  for (const Point& p : points) m.push_back(affine_row(p, is_lifted));
  return determinant(m).sign();
}

template <std::size_t N>
std::string reproduce(const std::array<Point2, N>& points) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Point2& p : points) out << "{" << p.x << ", " << p.y << "} ";
  return out.str();
}
template <std::size_t N>
std::string reproduce(const std::array<Point3, N>& points) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Point3& p : points) out << "{" << p.x << ", " << p.y << ", " << p.z << "} ";
  return out.str();
}

inline Point2 make_point(const Point2*, Random& random, double (*coordinate)(Random&)) {
  const double x = coordinate(random);
  return {x, coordinate(random)};
}
inline Point3 make_point(const Point3*, Random& random, double (*coordinate)(Random&)) {
  const double x = coordinate(random);
  const double y = coordinate(random);
  return {x, y, coordinate(random)};
}

inline double& at(Point2& p, std::size_t axis) {
  return axis == 0 ? p.x : p.y;
}
inline double& at(Point3& p, std::size_t axis) {
  return p[axis];
}
constexpr std::size_t dimension(const Point2*) {
  return 2;
}
constexpr std::size_t dimension(const Point3*) {
  return 3;
}

/// What coordinates of a family look like.
struct Family {
  const char* name;
  double (*coordinate)(Random&);
};

inline const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"unit", [](Random& r) { return std::uniform_real_distribution<double>(0, 1)(r); }},
      {"small integers", [](Random& r) { return small_integer(r, 4); }},
      {"a few ulps about 1", [](Random& r) { return 1 + std::ldexp(small_integer(r, 6), -52); }},
      {"any finite double", [](Random& r) { return any_finite(r); }},
      {"the ends of the range", [](Random& r) { return awkward(r); }},
      {"exponents of 300 digits", [](Random& r) { return with_exponent(r, -996, 996); }},
      {"spans of 100 bits", [](Random& r) { return with_exponent(r, -25, 25); }},
      {"subnormal", [](Random& r) { return std::ldexp(small_integer(r, 5), -1074); }},
      {"tiny", [](Random& r) { return std::ldexp(small_integer(r, 5), -900) * (1 + 0x1p-52 * small_integer(r, 3)); }},
      {"huge", [](Random& r) { return std::ldexp(small_integer(r, 5), 1020) * (1 + 0x1p-52 * small_integer(r, 3)); }},
  };
  return all;
}

/// N points of the family; some are copies or midpoints of others, or off them by one unit in the last place.
template <class Point, std::size_t N>
std::array<Point, N> near_degenerate(Random& random, const Family& family) {
  constexpr auto* tag = static_cast<const Point*>(nullptr);
  std::array<Point, N> points;
  for (Point& p : points) p = make_point(tag, random, family.coordinate);
  if (random() % 4 == 0) return points;
  Point& moved = points[random() % N];
  Point a = points[random() % N];
  Point b = points[random() % N];
  const double weight = std::ldexp(static_cast<double>(random() % 5), -2);
  for (std::size_t axis = 0; axis < dimension(tag); ++axis) {
    double x = at(a, axis) * (1 - weight) + at(b, axis) * weight;
    if (random() % 4 == 0) x = std::nextafter(x, random() % 2 == 0 ? 0.0 : 0x1p1023);
    at(moved, axis) = x;
  }
  return points;
}

/// Points of the integer grid 0 .. size in each coordinate.
inline std::vector<Point2> grid2(int size) {
  std::vector<Point2> points;
  for (int x = 0; x <= size; ++x) {
    for (int y = 0; y <= size; ++y) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  }
  return points;
}
inline std::vector<Point3> grid3(int size) {
  std::vector<Point3> points;
  for (int z = 0; z <= size; ++z) {
    for (const Point2& p : grid2(size)) points.push_back({p.x, p.y, static_cast<double>(z)});
  }
  return points;
}

}  // namespace quoin::testing
