// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/radial_order.h"

#include "quoin/base/error.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/kernel/predicates3.h"

namespace quoin {

namespace {

/// Where the angle from the reference lies: 0, (0, 180), 180 or (180, 360) degrees.
enum class Sector { same, left, opposite, right };

Sector sector_of(Sign turn, Sign along) {
  if (turn != Sign::zero) return turn == Sign::positive ? Sector::left : Sector::right;
  return along == Sign::positive ? Sector::same : Sector::opposite;
}

// Negative if the first comes before the second.
Sign order(Sector a, Sector b, Sign turn_from_a_to_b) {
  if (a != b) return a < b ? Sign::negative : Sign::positive;
  return a == Sector::left || a == Sector::right ? -turn_from_a_to_b : Sign::zero;
}

Point2 projected(const Point3& p, unsigned axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

Sign projected_turn(const Point3& a, const Point3& b, const Point3& c, unsigned axis) {
  return orientation(projected(a, axis), projected(b, axis), projected(c, axis));
}

bool is_on_line(const Point3& p, const Point3& q, const Point3& x) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (projected_turn(p, q, x, axis) != Sign::zero) return false;
  }
  return true;
}

// Of a point in the plane of p, q, reference: positive on the reference's side of the line.
Sign side_in_plane(const Point3& p, const Point3& q, const Point3& reference, const Point3& x) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    const Sign turn = projected_turn(p, q, reference, axis);
    if (turn != Sign::zero) return turn * projected_turn(p, q, x, axis);
  }
  return Sign::zero;
}

Sector sector_of(const Point3& p, const Point3& q, const Point3& reference, const Point3& x) {
  const Sign turn = orientation(p, q, reference, x);
  return sector_of(turn, turn == Sign::zero ? side_in_plane(p, q, reference, x) : Sign::zero);
}

Sector sector_of(const Constructions& table, LineId line, PlaneId reference, PlaneId plane) {
  if (plane == reference) return Sector::same;
  const Sign turn = table.triple(line, reference, plane);
  return sector_of(turn, turn == Sign::zero ? table.dot(reference, plane) : Sign::zero);
}

}  // namespace

Sign compare_radially(const Point3& p, const Point3& q, const Point3& reference, const Point3& a, const Point3& b) {
  if (is_on_line(p, q, reference) || is_on_line(p, q, a) || is_on_line(p, q, b)) {
    throw InputError("a point on an edge has no angle about it");
  }
  return order(sector_of(p, q, reference, a), sector_of(p, q, reference, b), orientation(p, q, a, b));
}

Sign compare_radially(const Constructions& table, LineId line, PlaneId reference, PlaneId a, PlaneId b) {
  return order(sector_of(table, line, reference, a), sector_of(table, line, reference, b), table.triple(line, a, b));
}

}  // namespace quoin
