// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/triangulation/test_clouds.h"

/// Families of points that lie in a plane, on a line or in one place, exactly, for tests of triangulations.
namespace quoin::testing {

/// A similarity of space with integer coefficients: a rotation by a quaternion of integers, of squared length n, which
/// makes lengths n times as long, and a translation.
class IntegerMotion {
 public:
  explicit IntegerMotion(Random& random) {
    std::array<double, 4> q{};
    do {
      for (double& x : q) x = small_integer(random, 3);
      factor_ = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    } while (factor_ == 0);
    const auto& [a, b, c, d] = q;
    rows_ = {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
              {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
              {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}}};
    for (std::size_t axis = 0; axis < 3; ++axis) shift_[axis] = small_integer(random, 20);
  }

  /// Exact for coordinates of few bits.
  Point3 operator()(const Point3& p) const {
    Point3 moved = shift_;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) moved[i] += rows_[i][k] * p[k];
    }
    return moved;
  }
  /// By which lengths grow.
  double factor() const { return factor_; }

 private:
  std::array<std::array<double, 3>, 3> rows_{};
  Point3 shift_;
  double factor_ = 0;
};

/// Images of integers (i, j) in a plane, or with j = 0 on a line, that is random or, rarely, degenerate.
class IntegerPlane {
 public:
  explicit IntegerPlane(Random& random, double scale = 1) : scale_(scale) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      origin_[axis] = small_integer(random, 5);
      first_[axis] = small_integer(random, 3);
      second_[axis] = small_integer(random, 3);
    }
  }
  Point3 at(double i, double j) const {
    Point3 p;
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[axis] = scale_ * (origin_[axis] + i * first_[axis] + j * second_[axis]);
    return p;
  }

 private:
  double scale_;
  Point3 origin_;
  Point3 first_;
  Point3 second_;
};

/// All orders of three numbers: of one circle, in a plane across the diagonal of space.
inline std::vector<Point3> orders_of(double a, double b, double c) {
  return {{a, b, c}, {a, c, b}, {b, a, c}, {b, c, a}, {c, a, b}, {c, b, a}};
}

/// About `count` points of each family, in a random order.
inline std::vector<Cloud> flat_clouds(Random& random, std::size_t count) {
  std::vector<Cloud> all;
  for (const int exponent : {0, -1074, 1010, -40}) {
    const std::string scale = " times 2^" + std::to_string(exponent);
    const IntegerPlane plane(random, std::ldexp(1.0, exponent));
    std::vector<Point3> grid;
    std::vector<Point3> scattered;
    std::vector<Point3> line;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 3; ++j) grid.push_back(plane.at(i, j));
    }
    for (std::size_t i = 0; i < count; ++i) {
      scattered.push_back(plane.at(small_integer(random, 7), small_integer(random, 7)));
      line.push_back(plane.at(small_integer(random, 6), 0));
    }
    all.push_back({"a grid" + scale, grid});
    all.push_back({"integers of a plane" + scale, scattered});
    all.push_back({"integers of a line" + scale, line});
  }
  const auto add = [&](const char* name, double (*coordinate)(Random&)) {
    const std::size_t axis = random() % 3;
    std::vector<Point3> level;
    std::vector<Point3> tilted;
    std::vector<Point3> line;
    for (std::size_t i = 0; i < count; ++i) {
      const double s = coordinate(random);
      const double t = coordinate(random);
      Point3 p{s, s, s};
      p[axis] = 0.1;
      p[(axis + 1) % 3] = t;
      level.push_back(p);
      p[axis] = -s;
      tilted.push_back(p);
      p[(axis + 1) % 3] = s;
      line.push_back(p);
    }
    all.push_back({std::string(name) + " of a level plane", level});
    all.push_back({std::string(name) + " of a tilted plane", tilted});
    all.push_back({std::string(name) + " of a line", line});
  };
  add("uniform", unit);
  add("any finite doubles", any_finite);
  add("the ends of the range", awkward);
  std::vector<Point3> circles = orders_of(0, 1, 3);
  for (const Point3& p : orders_of(-1, 2, 3)) circles.push_back(p);
  for (const Point3& p : orders_of(1, 1, 2)) circles.push_back(p);
  all.push_back({"circles", circles});
  all.push_back({"one place", std::vector<Point3>(3, {unit(random), 0, any_finite(random)})});
  for (Cloud& cloud : all) std::shuffle(cloud.points.begin(), cloud.points.end(), random);
  return all;
}

}  // namespace quoin::testing
