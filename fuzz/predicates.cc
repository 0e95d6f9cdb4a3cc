// SPDX-License-Identifier: Apache-2.0
//
// Predicates against their definitions in rationals, on points of a small grid moved by few ulps and scaled by any
// power of two.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "fuzz/promise.h"
#include "fuzz/targets.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/kernel/rational_point.h"

namespace quoin::fuzz {

namespace {

double coordinate(Bytes& in, int exponent) {
  double value = std::ldexp(static_cast<double>(in.next() % 16) - 8, exponent);
  const int ulps = in.next() % 8 - 4;
  for (int i = 0; i < ulps; ++i) value = std::nextafter(value, 1e308);
  return value;
}

Rational determinant(std::vector<std::vector<Rational>> m) {
  if (m.size() == 1) return m[0][0];
  Rational sum(0);
  for (std::size_t column = 0; column < m.size(); ++column) {
    std::vector<std::vector<Rational>> minor;
    for (std::size_t row = 1; row < m.size(); ++row) {
      minor.emplace_back();
      for (std::size_t c = 0; c < m.size(); ++c) {
        if (c != column) minor.back().push_back(m[row][c]);
      }
    }
    const Rational term = m[0][column] * determinant(minor);
    sum = column % 2 == 0 ? sum + term : sum - term;
  }
  return sum;
}

// Rows p - last and, for circles and spheres, their squared lengths.
template <class Point>
Sign by_definition(const std::vector<Point>& points, bool lifted) {
  const auto rational = [](const Point& p) {
    std::vector<Rational> row{p.x, p.y};
    if constexpr (requires { p.z; }) row.emplace_back(p.z);
    return row;
  };
  const std::vector<Rational> last = rational(points.back());
  std::vector<std::vector<Rational>> rows;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    std::vector<Rational> row = rational(points[i]);
    Rational square(0);
    for (std::size_t k = 0; k < row.size(); ++k) {
      row[k] -= last[k];
      square += row[k] * row[k];
    }
    if (lifted) row.push_back(square);
    rows.push_back(std::move(row));
  }
  return determinant(std::move(rows)).sign();
}

}  // namespace

void predicates(std::span<const std::uint8_t> bytes) {
  Bytes in(bytes);
  const int exponent = static_cast<int>(in.next()) * 4 - 512;
  std::vector<Point2> p2(4);
  for (Point2& p : p2) p = {coordinate(in, exponent), coordinate(in, exponent)};
  std::vector<Point3> p3(5);
  for (Point3& p : p3) p = {coordinate(in, exponent), coordinate(in, exponent), coordinate(in, exponent)};
  const std::vector<Point2> turn_reference{{0, 0}, {1, 0}, {0, 1}};
  const std::vector<Point2> circle_reference{{0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}};
  const std::vector<Point3> volume_reference{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Point3> sphere_reference{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0.5}};
  const auto turn = [](const auto& p) { return orientation(p[0], p[1], p[2]); };
  const auto circle = [](const auto& p) { return in_circle(p[0], p[1], p[2], p[3]); };
  const auto volume = [](const auto& p) { return orientation(p[0], p[1], p[2], p[3]); };
  const auto sphere = [](const auto& p) { return in_sphere(p[0], p[1], p[2], p[3], p[4]); };
  const auto check = [](const auto& predicate, const auto& points, const auto& reference, bool lifted,
                        const char* name) {
    const Sign convention = predicate(reference) * by_definition(reference, lifted);
    // The definitions above hold up to a fixed sign, taken where the answer is not zero.
    require(predicate(points) == by_definition(points, lifted) * convention, name);
  };
  check(turn, std::vector<Point2>(p2.begin(), p2.begin() + 3), turn_reference, false, "orientation in the plane");
  check(circle, p2, circle_reference, true, "in_circle");
  check(volume, std::vector<Point3>(p3.begin(), p3.begin() + 4), volume_reference, false, "orientation in space");
  check(sphere, p3, sphere_reference, true, "in_sphere");
}

}  // namespace quoin::fuzz
