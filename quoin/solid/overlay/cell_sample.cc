// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/cell_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "quoin/solid/overlay/winding.h"

namespace quoin::overlay {

namespace {

using Triangle = std::array<RationalPoint3, 3>;

Rational squared_distance_to_segment(const RationalPoint3& p, const RationalPoint3& a, const RationalPoint3& b) {
  const RationalPoint3 along = b - a;
  const Rational length = dot(along, along);
  const Rational place = dot(p - a, along);
  if (place.sign() != Sign::positive) return dot(p - a, p - a);
  if (place >= length) return dot(p - b, p - b);
  return dot(p - a, p - a) - place * place / length;
}

/// The triangle has an area.
Rational squared_distance(const RationalPoint3& p, const Triangle& t) {
  const RationalPoint3 normal = cross(t[1] - t[0], t[2] - t[0]);
  bool is_above = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const RationalPoint3& a = t[k];
    if (dot(cross(t[(k + 1) % 3] - a, p - a), normal).sign() == Sign::negative) is_above = false;
  }
  if (is_above) {
    const Rational height = dot(p - t[0], normal);
    return height * height / dot(normal, normal);
  }
  return std::min({squared_distance_to_segment(p, t[0], t[1]), squared_distance_to_segment(p, t[1], t[2]),
                   squared_distance_to_segment(p, t[2], t[0])});
}

/// Below the distance of a point from the box of a tile, by rounded coordinates. Those of the point and of the corners
/// err by u of themselves, differences and the root by a few u more; what falls below the range of doubles counts as 0.
double least_distance(const Point3& p, const Constructions& table, const Corners& corners) {
  double sum = 0;
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = table.rounded(corners[0])[axis];
    double high = low;
    for (std::size_t k = 1; k < 3; ++k) {
      low = std::min(low, table.rounded(corners[k])[axis]);
      high = std::max(high, table.rounded(corners[k])[axis]);
    }
    const double gap = std::max({low - p[axis], p[axis] - high, 0.0});
    sum += gap * gap;
    size = std::max({size, std::fabs(low), std::fabs(high), std::fabs(p[axis])});
  }
  return std::max(0.0, std::sqrt(sum) * (1 - 0x1p-48) - size * 0x1p-48);
}

/// The squared distance from p to the nearest tile that does not hold it.
Rational squared_room(const Sheets& sheets, const RationalPoint3& p, const Context& context) {
  const Constructions& table = sheets.scene->table;
  const Point3 rounded{p.x.to_double(), p.y.to_double(), p.z.to_double()};
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t t = 0; t < sheets.tile_count(); ++t) {
    order.push_back({least_distance(rounded, table, sheets.corners(t)), t});
  }
  // A heap: only the first few are taken out in order.
  std::make_heap(order.begin(), order.end(), std::greater<>());
  Rational nearest(0);
  for (auto end = order.end(); end != order.begin(); --end) {
    context.poll();
    std::pop_heap(order.begin(), end, std::greater<>());
    const auto& [least, tile] = *(end - 1);
    if (nearest.sign() == Sign::positive && Rational(least) * Rational(least) > nearest) break;
    const Corners c = sheets.corners(tile);
    const Rational found = squared_distance(p, {table.exact(c[0]), table.exact(c[1]), table.exact(c[2])});
    if (found.sign() == Sign::positive && (nearest.sign() == Sign::zero || found < nearest)) nearest = found;
  }
  return nearest;
}

/// The largest power of two whose square is at most `square`, which is positive.
Rational power_of_two_below(const Rational& square) {
  Rational power(1);
  const Rational two(2);
  while (power * power > square) power /= two;
  while (power * power * Rational(4) <= square) power *= two;
  return power;
}

Rational rounded_to(const Rational& value, const Rational& unit) {
  const Rational scaled = value / unit + Rational(1) / Rational(2);
  return Rational(floor_quotient(scaled.numerator(), scaled.denominator())) * unit;
}

}  // namespace

RationalPoint3 point_near_sheet(const Sheets& sheets, std::uint32_t sheet, bool in_front, const Context& context) {
  const Constructions& table = sheets.scene->table;
  const RationalPoint3 base = interior_point(sheets, sheet);
  const Rational room = squared_room(sheets, base, context);
  const Corners c = sheets.corners(sheet);
  const RationalPoint3 a = table.exact(c[0]);
  RationalPoint3 normal = cross(table.exact(c[1]) - a, table.exact(c[2]) - a);
  if (!in_front) normal = normal * Rational(-1);
  const Rational reach = power_of_two_below(room);
  // Half of the reach along the normal, moved by less than a quarter of that in every coordinate.
  const Rational step = reach / Rational(4) / power_of_two_below(dot(normal, normal));
  const RationalPoint3 aim = base + normal * step;
  const Rational unit = reach / Rational(16);
  return {rounded_to(aim.x, unit), rounded_to(aim.y, unit), rounded_to(aim.z, unit)};
}

}  // namespace quoin::overlay
