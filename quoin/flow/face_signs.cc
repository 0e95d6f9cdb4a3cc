// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/face_signs.h"

#include <algorithm>
#include <cmath>

#include "quoin/flow/face_formulas.h"
#include "quoin/number/rational.h"

namespace quoin {

namespace {

using flow::between;
using flow::Circle;
using flow::Vector;

double largest(const Vector<double>& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// A vertex of the cell that is not of the polygon; both are short lists.
std::uint32_t vertex_off(const DeloneFaces& faces, std::uint32_t cell, std::uint32_t f) {
  const std::span<const std::uint32_t> polygon = faces.polygon(f);
  for (const std::uint32_t v : faces.cell(cell)) {
    if (std::find(polygon.begin(), polygon.end(), v) == polygon.end()) return v;
  }
  return DeloneFaces::outside;
}

}  // namespace

Sign side_of_diametral_sphere(const Point3& p0, const Point3& p1, const Point3& q) {
  const Vector<double> a = between<double>(p0, q);
  const Vector<double> b = between<double>(p1, q);
  const double x = a.x * b.x;
  const double y = a.y * b.y;
  const double z = a.z * b.z;
  const double value = x + y + z;
  // Two differences, a product and two sums round: 5 u of the sum of magnitudes, which rounds three times itself.
  const double bound = 1.2e-15 * (std::fabs(x) + std::fabs(y) + std::fabs(z)) + 0x1p-1000;
  if (value > bound) return Sign::positive;
  if (value < -bound) return Sign::negative;
  return flow::power_to_edge<Rational>(p0, p1, q).sign();
}

Sign side_of_great_sphere(const std::array<Point3, 3>& circle, const Point3& q) {
  const Vector<double> to = between<double>(circle[0], q);
  const double m = std::max(
      {largest(to), largest(between<double>(circle[0], circle[1])), largest(between<double>(circle[0], circle[2]))});
  // With coordinates up to m, |normal| <= 2 m^2 each, square_normal <= 12 m^4, |q|^2 <= 3 m^2, centre <= 24 m^5 each:
  // magnitudes of 36 m^6 + 72 m^6, along at most 20 roundings, together 2.5e-13 m^6. What underflows in the range below
  // is 2^-1074 times at most 100 m^4, far less than the bound.
  if (m >= 0x1p-140 && m <= 0x1p140) {
    const double value = Circle<double>(circle).power(to);
    const double bound = 1e-12 * m * m * m * m * m * m;
    if (value > bound) return Sign::positive;
    if (value < -bound) return Sign::negative;
  }
  return Circle<Rational>(circle).power(between<Rational>(circle[0], q)).sign();
}

FaceSigns::FaceSigns(const DeloneFaces& faces, std::span<const Point3> points, const Context& context) {
  const auto polygons = static_cast<std::uint32_t>(faces.count(2));
  for (std::uint32_t f = 0; f < polygons; ++f) {
    if (f % 256 == 0) context.poll();
    const std::span<const std::uint32_t> corners = faces.polygon(f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t next = corners[(i + 1) % corners.size()];
      at_side_.push_back(side_of_diametral_sphere(points[corners[i]], points[next], points[faces.apex(f, i)]));
    }
    const std::array<Point3, 3> circle{points[corners[0]], points[corners[1]], points[corners[2]]};
    std::array<Sign, 2> signs{Sign::positive, Sign::positive};
    for (std::size_t side = 0; side < 2; ++side) {
      const std::uint32_t cell = faces.cells_of_polygon(f)[side];
      if (cell != DeloneFaces::outside) signs[side] = side_of_great_sphere(circle, points[vertex_off(faces, cell, f)]);
    }
    at_polygon_.push_back(signs);
  }
}

}  // namespace quoin
