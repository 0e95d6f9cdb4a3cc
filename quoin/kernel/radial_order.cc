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

/// Predicates on points of doubles.
struct ExplicitPredicates {
  using Point = const Point3&;

  Sign orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) const {
    return quoin::orientation(a, b, c, d);
  }
  Sign turn(const Point3& a, const Point3& b, const Point3& c, unsigned axis) const {
    return quoin::orientation(projected(a, axis), projected(b, axis), projected(c, axis));
  }
  static Point2 projected(const Point3& p, unsigned axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }
};

/// Predicates on points of a table.
struct TablePredicates {
  using Point = PointId;
  const Constructions& table;

  Sign orientation(PointId a, PointId b, PointId c, PointId d) const { return table.orientation_any(a, b, c, d); }
  Sign turn(PointId a, PointId b, PointId c, unsigned axis) const { return table.turn_any(a, b, c, axis); }
};

template <class Predicates>
bool is_on_line(const Predicates& on, typename Predicates::Point p, typename Predicates::Point q,
                typename Predicates::Point x) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (on.turn(p, q, x, axis) != Sign::zero) return false;
  }
  return true;
}

// Of a point in the plane of p, q, reference: positive on the reference's side of the line.
template <class Predicates>
Sign side_in_plane(const Predicates& on, typename Predicates::Point p, typename Predicates::Point q,
                   typename Predicates::Point reference, typename Predicates::Point x) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    const Sign turn = on.turn(p, q, reference, axis);
    if (turn != Sign::zero) return turn * on.turn(p, q, x, axis);
  }
  return Sign::zero;
}

template <class Predicates>
Sector sector_of(const Predicates& on, typename Predicates::Point p, typename Predicates::Point q,
                 typename Predicates::Point reference, typename Predicates::Point x) {
  const Sign turn = on.orientation(p, q, reference, x);
  return sector_of(turn, turn == Sign::zero ? side_in_plane(on, p, q, reference, x) : Sign::zero);
}

template <class Predicates>
Sign compare_points_radially(const Predicates& on, typename Predicates::Point p, typename Predicates::Point q,
                             typename Predicates::Point reference, typename Predicates::Point a,
                             typename Predicates::Point b) {
  if (is_on_line(on, p, q, reference) || is_on_line(on, p, q, a) || is_on_line(on, p, q, b)) {
    throw InputError("a point on an edge has no angle about it");
  }
  return order(sector_of(on, p, q, reference, a), sector_of(on, p, q, reference, b), on.orientation(p, q, a, b));
}

Sector sector_of(const Constructions& table, LineId line, PlaneId reference, PlaneId plane) {
  if (plane == reference) return Sector::same;
  const Sign turn = table.triple(line, reference, plane);
  return sector_of(turn, turn == Sign::zero ? table.dot(reference, plane) : Sign::zero);
}

}  // namespace

Sign compare_radially(const Point3& p, const Point3& q, const Point3& reference, const Point3& a, const Point3& b) {
  return compare_points_radially(ExplicitPredicates{}, p, q, reference, a, b);
}

Sign compare_radially(const Constructions& table, PointId p, PointId q, PointId reference, PointId a, PointId b) {
  return compare_points_radially(TablePredicates{table}, p, q, reference, a, b);
}

Sign compare_radially(const Constructions& table, LineId line, PlaneId reference, PlaneId a, PlaneId b) {
  return order(sector_of(table, line, reference, a), sector_of(table, line, reference, b), table.triple(line, a, b));
}

}  // namespace quoin
