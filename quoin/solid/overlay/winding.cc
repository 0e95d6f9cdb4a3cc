// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/winding.h"

#include <cmath>
#include <limits>
#include <utility>

#include "quoin/kernel/projection.h"
#include "quoin/solid/placed_point.h"
#include "quoin/solid/polygon_interior.h"

namespace quoin::overlay {

namespace {

// The line through a point along an axis, against tiles. Coordinates u and v are the other two.
class LineThroughPoint {
 public:
  LineThroughPoint(const Constructions& table, RationalPoint3 point, unsigned axis)
      : table_(table), point_(table, std::move(point)), axis_(axis) {}

  const Point3& near() const { return point_.rounded(); }

  /// +1 or -1 when the tile lies above the point and its normal points up or down, else 0.
  int above(const Corners& tile) const {
    bool inside = false;
    for (std::size_t k = 0; k < 3; ++k) {
      if (ray_crosses(tile[k], tile[(k + 1) % 3])) inside = !inside;
    }
    if (!inside) return 0;
    const Sign up = table_.turn(tile[0], tile[1], tile[2], axis_);
    return up * point_.side(tile[0], tile[1], tile[2]) == Sign::negative ? to_int(up) : 0;
  }

 private:
  bool is_after(PointId p, unsigned axis) const { return point_.compare(p, axis) == Sign::positive; }

  // Whether the edge crosses the ray from (u + e, v + e^2) towards larger v, for an infinitesimal e.
  bool ray_crosses(PointId a, PointId b) const {
    const unsigned u = (axis_ + 1) % 3;
    const bool a_after = is_after(a, u);
    const bool b_after = is_after(b, u);
    if (a_after == b_after) return false;
    const Sign left = left_of(a, b);
    return left == (b_after ? Sign::negative : Sign::positive);
  }

  // Left of a, b is the point moved by (e, e^2); a and b differ in u.
  Sign left_of(PointId a, PointId b) const {
    const Sign sign = point_.turn(a, b, axis_);
    if (sign != Sign::zero) return sign;
    const RationalPoint3 pa = table_.exact(a);
    const RationalPoint3 pb = table_.exact(b);
    const unsigned u = (axis_ + 1) % 3;
    const unsigned v = (axis_ + 2) % 3;
    const Sign rise = (pb[v] - pa[v]).sign();
    if (rise != Sign::zero) return -rise;
    return (pb[u] - pa[u]).sign();
  }

  const Constructions& table_;
  PlacedPoint point_;
  unsigned axis_;
};

double below(double x) {
  return std::nextafter(x, -std::numeric_limits<double>::infinity());
}
double above(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity());
}

}  // namespace

RationalPoint3 interior_point(const Sheets& sheets, std::uint32_t sheet) {
  const Constructions& table = sheets.scene->table;
  if (sheets.is_region(sheet)) {
    const Subdivision& cut = *sheets.subdivision;
    const std::uint32_t region = sheets.region(sheet);
    std::vector<std::span<const PointId>> loops;
    for (std::uint32_t l = cut.region_first_loop[region]; l < cut.region_first_loop[region + 1]; ++l) {
      loops.push_back(cut.loop(l));
    }
    const PlaneId plane{cut.region_facet[region]};
    const unsigned axis = table.main_axis(plane);
    return quoin::interior_point(table, loops, axis, table.normal_component(plane, axis));
  }
  const Corners corners = sheets.corners(sheet);
  return (table.exact(corners[0]) + table.exact(corners[1]) + table.exact(corners[2])) * (Rational(1) / Rational(3));
}

SheetWinding winding_at(const Sheets& sheets, std::uint32_t sheet) {
  const Scene& scene = *sheets.scene;
  const Corners corners = sheets.corners(sheet);
  const unsigned axis = projection_axis(scene.table, corners[0], corners[1], corners[2]);
  const LineThroughPoint line(scene.table, interior_point(sheets, sheet), axis);
  const double u = line.near()[(axis + 1) % 3];
  const double v = line.near()[(axis + 2) % 3];
  SheetWinding result;
  result.in_front = scene.table.turn(corners[0], corners[1], corners[2], axis) == Sign::positive;
  std::vector<std::uint32_t> tiles;
  for (std::uint32_t leaf = 0; leaf < scene.leaves.size(); ++leaf) {
    tiles.clear();
    scene.leaves[leaf]->tree.tiles_on_line(axis, {below(u), below(v)}, {above(u), above(v)}, tiles);
    int number = 0;
    for (const std::uint32_t t : tiles) number += line.above(scene.corners(scene.first_tile[leaf] + t, leaf));
    if (number != 0) result.windings.push_back({leaf, number});
  }
  return result;
}

}  // namespace quoin::overlay
