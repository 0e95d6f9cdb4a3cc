// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "quoin/kernel/test_points.h"

/// Sets of points for tests of triangulations of the plane.
namespace quoin::testing {

inline std::string reproduce(const std::vector<Point2>& points) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Point2& p : points) out << "{" << p.x << ", " << p.y << "}, ";
  return out.str();
}

struct PointSetFamily {
  const char* name;
  std::vector<Point2> (*make)(Random& random, std::size_t count);
};

template <class Make>
std::vector<Point2> repeat(std::size_t count, const Make& make) {
  std::vector<Point2> points;
  while (points.size() < count) points.push_back(make());
  return points;
}

inline double fraction(Random& random) {
  return std::uniform_real_distribution<double>(0, 1)(random);
}

inline Point2 on_circle(Random& random) {
  // Pythagorean points of the circle of radius 65, exactly: 36 of them.
  static const std::vector<Point2> quarter{{65, 0},  {63, 16}, {60, 25}, {56, 33}, {52, 39},
                                           {39, 52}, {33, 56}, {25, 60}, {16, 63}};
  Point2 p = quarter[random() % quarter.size()];
  for (std::size_t turns = random() % 4; turns > 0; --turns) p = {-p.y, p.x};
  return p;
}

inline const std::vector<PointSetFamily>& point_sets() {
  static const std::vector<PointSetFamily> all{
      {"uniform", [](Random& r, std::size_t n) { return repeat(n, [&] {
                                                   return Point2{fraction(r), fraction(r)};
                                                 }); }},
      {"small grid",
       [](Random& r, std::size_t n) {
         const int side = 1 + static_cast<int>(std::sqrt(static_cast<double>(n)));
         return repeat(n, [&] { return Point2{small_integer(r, side), small_integer(r, side)}; });
       }},
      {"lattice far from the origin",
       [](Random& r, std::size_t n) {
         const double far = std::ldexp(1.0, static_cast<int>(r() % 50));
         return repeat(n, [&] { return Point2{far + small_integer(r, 3), far + small_integer(r, 3)}; });
       }},
      {"on a circle", [](Random& r, std::size_t n) { return repeat(n, [&] { return on_circle(r); }); }},
      {"near a circle",
       [](Random& r, std::size_t n) {
         return repeat(n, [&] {
           const double angle = 6.28 * fraction(r);
           return Point2{std::cos(angle), std::sin(angle)};
         });
       }},
      {"on a line",
       [](Random& r, std::size_t n) {
         return repeat(n, [&] {
           const double t = small_integer(r, 40);
           return Point2{3 * t + 1, 2 * t - 5};
         });
       }},
      {"near a line",
       [](Random& r, std::size_t n) {
         return repeat(n, [&] {
           const double t = fraction(r);
           return Point2{t, r() % 8 == 0 ? std::nextafter(t, 0.0) : t};
         });
       }},
      {"one point many times", [](Random&, std::size_t n) { return repeat(n, [] {
                                                              return Point2{0.5, -3};
                                                            }); }},
      {"a grid, each many times",
       [](Random& r, std::size_t n) {
         return repeat(n, [&] {
           return Point2{small_integer(r, 1) + 0.0 * fraction(r), -0.0 * small_integer(r, 1) + small_integer(r, 1)};
         });
       }},
      {"any doubles",
       [](Random& r, std::size_t n) { return repeat(n, [&] {
                                        return Point2{any_finite(r), any_finite(r)};
                                      }); }},
      {"the ends of the range",
       [](Random& r, std::size_t n) { return repeat(n, [&] {
                                        return Point2{awkward(r), awkward(r)};
                                      }); }},
      {"1e300 beside 1e-300",
       [](Random& r, std::size_t n) {
         return repeat(n, [&] {
           const double size = r() % 2 == 0 ? 1e300 : 1e-300;
           return Point2{size * small_integer(r, 3), size * small_integer(r, 3)};
         });
       }},
      {"subnormal",
       [](Random& r, std::size_t n) {
         return repeat(n, [&] {
           return Point2{std::ldexp(small_integer(r, 9), -1074), std::ldexp(small_integer(r, 9), -1074)};
         });
       }},
      {"clusters in clusters",
       [](Random& r, std::size_t n) {
         return repeat(n, [&] {
           const int level = -static_cast<int>(r() % 30);
           return Point2{std::ldexp(fraction(r), 3 * level), std::ldexp(fraction(r), 3 * level)};
         });
       }},
      {"two lines",
       [](Random& r, std::size_t n) {
         return repeat(n, [&] {
           const double t = small_integer(r, 20);
           return r() % 2 == 0 ? Point2{t, 0} : Point2{0, t};
         });
       }},
  };
  return all;
}

}  // namespace quoin::testing
