// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "quoin/base/error.h"

namespace quoin {

namespace {

std::string decimals(double value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value == 0 ? 0.0 : value).ptr;
  return {digits.data(), end};
}

// Orthonormal axes of the drawing, rounded.
struct Frame {
  Point3 right;
  Point3 up;
};

Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot(const Point3& a, const Point3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Point3 unit(const Point3& a) {
  const double length = std::hypot(a.x, a.y, a.z);
  return {a.x / length, a.y / length, a.z / length};
}

Frame frame_of(const SectionPlane& plane) {
  const Rational size = std::max({abs(plane.normal.x), abs(plane.normal.y), abs(plane.normal.z)});
  const RationalPoint3 scaled = plane.normal * (Rational(1) / size);
  const Point3 normal = unit({scaled.x.to_double(), scaled.y.to_double(), scaled.z.to_double()});
  const bool along_x = std::fabs(normal.x) > std::fabs(normal.y) && std::fabs(normal.x) > std::fabs(normal.z);
  const Point3 axis = along_x ? Point3{0, 1, 0} : Point3{1, 0, 0};
  const double lean = dot(axis, normal);
  const Point3 right = unit({axis.x - lean * normal.x, axis.y - lean * normal.y, axis.z - lean * normal.z});
  return {right, cross(normal, right)};
}

}  // namespace

SvgReport write_svg(std::ostream& out, const Section& section, const SectionPlane& plane) {
  if (section.is_unbounded) throw InputError("an unbounded section cannot be drawn");
  const Frame frame = frame_of(plane);
  std::vector<std::array<double, 2>> points;
  double size = 0;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 4> box{infinity, infinity, -infinity, -infinity};
  for (const RationalPoint3& p : section.points) {
    const Point3 q{p.x.to_double(), p.y.to_double(), p.z.to_double()};
    size = std::max({size, std::fabs(q.x), std::fabs(q.y), std::fabs(q.z)});
    points.push_back({dot(frame.right, q), -dot(frame.up, q)});
    for (std::size_t k = 0; k < 2; ++k) {
      box[k] = std::min(box[k], points.back()[k]);
      box[k + 2] = std::max(box[k + 2], points.back()[k]);
    }
  }
  if (points.empty()) box = {0, 0, 0, 0};
  const std::string width = decimals(box[2] - box[0]);
  const std::string height = decimals(box[3] - box[1]);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "mm\" height=\"" << height
      << "mm\" viewBox=\"" << decimals(box[0]) << " " << decimals(box[1]) << " " << width << " " << height << "\">\n"
      << "<path fill=\"#9bb8d3\" fill-rule=\"evenodd\" stroke=\"#1b2a3a\" stroke-width=\"1\" "
         "vector-effect=\"non-scaling-stroke\" d=\"";
  for (const auto& loop : section.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      out << (i == 0 ? "M" : "L") << decimals(points[loop[i]][0]) << " " << decimals(points[loop[i]][1]) << " ";
    }
    out << "Z\n";
  }
  out << "\"/>\n</svg>\n";
  // Rounded point: 1/2 ulp of each coordinate; axes within 8 units of 2^-53 each; three products and two sums.
  return {48 * 0x1p-53 * size};
}

}  // namespace quoin
