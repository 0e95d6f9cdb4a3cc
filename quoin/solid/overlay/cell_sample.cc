// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/cell_sample.h"

#include <vector>

#include "quoin/base/error.h"
#include "quoin/solid/nearest_tile.h"
#include "quoin/solid/overlay/winding.h"

namespace quoin::overlay {

namespace {

/// The squared distance from p to the nearest tile that does not hold it.
Rational squared_room(const Sheets& sheets, const RationalPoint3& p, const Context& context) {
  std::vector<Corners> tiles;
  tiles.reserve(sheets.tile_count());
  for (std::uint32_t t = 0; t < sheets.tile_count(); ++t) tiles.push_back(sheets.corners(t));
  const auto nearest = nearest_point(p, sheets.scene->table, tiles, TouchingTiles::are_left_out, context);
  if (!nearest) throw InternalError("a closed surface lies in a plane");
  return nearest->squared_distance;
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
