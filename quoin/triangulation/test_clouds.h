// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/number/test_doubles.h"

/// Families of points for tests of triangulations.
namespace quoin::testing {

struct Cloud {
  std::string name;
  std::vector<Point3> points;
};

inline std::vector<Point3> lattice(int x, int y, int z) {
  std::vector<Point3> points;
  for (int i = 0; i < x; ++i) {
    for (int j = 0; j < y; ++j) {
      for (int k = 0; k < z; ++k) {
        points.push_back({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
      }
    }
  }
  return points;
}

inline std::vector<Point3> random_points(Random& random, std::size_t count, double (*coordinate)(Random&)) {
  std::vector<Point3> points(count);
  for (Point3& p : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = coordinate(random);
  }
  return points;
}

inline double unit(Random& random) {
  return std::uniform_real_distribution<double>(-1, 1)(random);
}

/// Directions scaled to the unit sphere, with the roundings that leaves.
inline std::vector<Point3> near_sphere(Random& random, std::size_t count) {
  std::vector<Point3> points = random_points(random, count, unit);
  for (Point3& p : points) {
    const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    p = {p.x / length, p.y / length, p.z / length};
  }
  return points;
}

/// All permutations of (0, +-1, +-2): 24 points of one sphere.
inline std::vector<Point3> cospherical() {
  std::vector<Point3> points;
  for (const auto& [i, j, k] :
       {std::array{0U, 1U, 2U}, {0U, 2U, 1U}, {1U, 0U, 2U}, {1U, 2U, 0U}, {2U, 0U, 1U}, {2U, 1U, 0U}}) {
    for (const double one : {-1.0, 1.0}) {
      for (const double two : {-2.0, 2.0}) {
        Point3 p;
        p[i] = 0;
        p[j] = one;
        p[k] = two;
        points.push_back(p);
      }
    }
  }
  return points;
}

/// About `count` points of each family, in a random order.
inline std::vector<Cloud> clouds(Random& random, std::size_t count) {
  std::vector<Cloud> all;
  const auto random_cloud = [&](const char* name, double (*coordinate)(Random&)) {
    all.push_back({name, random_points(random, count, coordinate)});
  };
  random_cloud("uniform", unit);
  random_cloud("integers within 2", [](Random& r) { return small_integer(r, 2); });
  random_cloud("integers within 9", [](Random& r) { return small_integer(r, 9); });
  random_cloud("a few ulps about 1", [](Random& r) { return 1 + std::ldexp(small_integer(r, 6), -52); });
  random_cloud("any finite double", any_finite);
  random_cloud("the ends of the range", awkward);
  random_cloud("1e300 and 1e-300", [](Random& r) { return small_integer(r, 2) * (r() % 2 == 0 ? 1e300 : 1e-300); });
  random_cloud("huge", [](Random& r) { return std::ldexp(small_integer(r, 5), 1020); });
  random_cloud("subnormal", [](Random& r) { return std::ldexp(small_integer(r, 5), -1074); });
  all.push_back({"near a sphere", near_sphere(random, count)});
  all.push_back({"lattice", lattice(3, 4, 3)});
  all.push_back({"cospherical", cospherical()});
  all.push_back({"planar lattice", lattice(4, 4, 1)});
  all.push_back({"collinear lattice", lattice(1, 7, 1)});
  all.push_back({"one point", lattice(1, 1, 1)});
  std::vector<Point3> tilted;
  for (const Point3& p : random_points(random, count, [](Random& r) { return small_integer(r, 4); })) {
    tilted.push_back({p.x, p.y, p.x + 2 * p.y});
  }
  all.push_back({"a tilted plane", tilted});
  std::vector<Point3> line;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = small_integer(random, 20);
    line.push_back({t, -2 * t, 3 * t});
  }
  all.push_back({"a line", line});
  std::vector<Point3> skew;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = unit(random);
    skew.push_back(i % 2 == 0 ? Point3{t, 0, 0} : Point3{0, t, 1});
  }
  all.push_back({"two skew lines", skew});
  std::vector<Point3> moments;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / 8;
    moments.push_back({t, t * t, t * t * t});
  }
  all.push_back({"moment curve", moments});
  std::vector<Point3> repeated = random_points(random, count, unit);
  for (std::size_t i = 0; i < count; ++i) repeated[i] = repeated[i % (count / 5 + 1)];
  all.push_back({"repeated", repeated});
  for (Cloud& cloud : all) std::shuffle(cloud.points.begin(), cloud.points.end(), random);
  return all;
}

}  // namespace quoin::testing
