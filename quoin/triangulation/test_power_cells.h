// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "quoin/kernel/rational_point.h"
#include "quoin/number/test_doubles.h"

/// Power cells by their definition, in rationals, and weights for tests.
namespace quoin::testing {

struct WeightFamily {
  const char* name;
  double (*weight)(Random&, double square);  ///< of a point with this square of its distance from the origin
};

/// With squares as weights all lifted points lie in a plane, and with a little more or less near one.
inline const std::vector<WeightFamily>& weight_families() {
  static const std::vector<WeightFamily> all{
      {"zero", [](Random&, double) { return 0.0; }},
      {"equal", [](Random&, double) { return 2.5; }},
      {"small integers", [](Random& r, double) { return small_integer(r, 3); }},
      {"fractions", [](Random& r, double) { return std::uniform_real_distribution<double>(-0.25, 0.25)(r); }},
      {"a few large ones", [](Random& r, double) { return r() % 8 == 0 ? 50.0 + small_integer(r, 40) : 0.0; }},
      {"squares", [](Random&, double square) { return std::isfinite(square) ? square : 0; }},
      {"squares or one less",
       [](Random& r, double square) { return (std::isfinite(square) ? square : 0) - static_cast<double>(r() % 2); }},
      {"any doubles", [](Random& r, double) { return any_finite(r); }},
      {"subnormal", [](Random& r, double) { return small_integer(r, 2) * 0x1p-1074; }},
  };
  return all;
}

inline Rational power(const RationalPoint3& x, const Point3& p, double weight) {
  const RationalPoint3 way = x - exact_point(p);
  return dot(way, way) - Rational(weight);
}

/// A convex polyhedron by its sides, as lists of corners in order, and what is left of it in half-spaces.
class ClippedBox {
 public:
  explicit ClippedBox(const Rational& far) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      for (const Rational& at : {-far, far}) {
        std::vector<RationalPoint3> side;
        for (const auto& [u, v] : {std::pair(-far, -far), {far, -far}, {far, far}, {-far, far}}) {
          side.push_back(axis == 0   ? RationalPoint3{at, u, v}
                         : axis == 1 ? RationalPoint3{v, at, u}
                                     : RationalPoint3{u, v, at});
        }
        sides_.push_back(side);
      }
    }
  }

  /// Where `height`, an affine function, is not negative.
  template <class Height>
  void clip(const Height& height) {
    std::vector<std::vector<RationalPoint3>> kept;
    std::vector<RationalPoint3> cut;
    for (const std::vector<RationalPoint3>& side : sides_) {
      std::vector<RationalPoint3> polygon;
      for (std::size_t i = 0; i < side.size(); ++i) {
        const RationalPoint3& p = side[i];
        const RationalPoint3& q = side[(i + 1) % side.size()];
        const Rational at_p = height(p);
        const Rational at_q = height(q);
        if (at_p.sign() != Sign::negative) polygon.push_back(p);
        if (at_p.sign() == Sign::zero) cut.push_back(p);
        if (at_p.sign() * at_q.sign() != Sign::negative) continue;
        polygon.push_back(p + (q - p) * (at_p / (at_p - at_q)));
        cut.push_back(polygon.back());
      }
      if (has_area(polygon)) kept.push_back(polygon);
    }
    sides_ = std::move(kept);
    const std::vector<RationalPoint3> cap = convex_order(cut);
    if (!sides_.empty() && has_area(cap) &&
        std::ranges::none_of(sides_, [&](const auto& s) { return is_of(s, height); }))
      sides_.push_back(cap);
  }

  Rational volume() const {
    Rational six;
    for (const std::vector<RationalPoint3>& side : sides_) {
      for (std::size_t i = 2; i < side.size(); ++i) {
        const RationalPoint3& apex = sides_[0][0];
        six += abs(dot(side[0] - apex, cross(side[i - 1] - apex, side[i] - apex)));
      }
    }
    return six / Rational(6);
  }

  std::vector<RationalPoint3> corners() const {
    std::vector<RationalPoint3> all;
    for (const auto& side : sides_) all.insert(all.end(), side.begin(), side.end());
    sort_distinct(all);
    return all;
  }

  static void sort_distinct(std::vector<RationalPoint3>& points) {
    std::ranges::sort(points, [](const RationalPoint3& a, const RationalPoint3& b) {
      return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    });
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }

  /// Not all on a line.
  static bool has_area(const std::vector<RationalPoint3>& points) {
    for (std::size_t i = 2; i < points.size(); ++i) {
      const RationalPoint3 normal = cross(points[1] - points[0], points[i] - points[0]);
      if (!(normal == RationalPoint3{})) return true;
    }
    return false;
  }

 private:
  template <class Height>
  static bool is_of(const std::vector<RationalPoint3>& side, const Height& height) {
    return std::ranges::all_of(side, [&](const RationalPoint3& p) { return height(p).sign() == Sign::zero; });
  }

  /// Corners of a convex polygon, around it.
  static std::vector<RationalPoint3> convex_order(std::vector<RationalPoint3> points) {
    sort_distinct(points);
    if (points.size() < 3 || !has_area(points)) return {};
    RationalPoint3 normal;
    for (std::size_t i = 2; normal == RationalPoint3{}; ++i)
      normal = cross(points[1] - points[0], points[i] - points[0]);
    // Seen from the first corner all others are within half a turn.
    std::sort(points.begin() + 1, points.end(), [&](const RationalPoint3& a, const RationalPoint3& b) {
      return dot(normal, cross(a - points[0], b - points[0])).sign() == Sign::positive;
    });
    return points;
  }

  std::vector<std::vector<RationalPoint3>> sides_;
};

}  // namespace quoin::testing
