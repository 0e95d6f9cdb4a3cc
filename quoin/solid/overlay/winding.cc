// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/winding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quoin/base/error.h"
#include "quoin/kernel/projection.h"

namespace quoin::overlay {

namespace {

constexpr double unit = 0x1p-53;  // half an ulp of 1

const Rational& coordinate(const RationalPoint3& p, unsigned axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

Rational cross(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c, unsigned axis) {
  const unsigned u = (axis + 1) % 3;
  const unsigned v = (axis + 2) % 3;
  return (coordinate(b, u) - coordinate(a, u)) * (coordinate(c, v) - coordinate(a, v)) -
         (coordinate(b, v) - coordinate(a, v)) * (coordinate(c, u) - coordinate(a, u));
}

RationalPoint3 mean(const RationalPoint3& a, const RationalPoint3& b) {
  const Rational half(0.5);
  return {(a.x + b.x) * half, (a.y + b.y) * half, (a.z + b.z) * half};
}

RationalPoint3 mean(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c) {
  const Rational third = Rational(1.0) / Rational(3.0);
  return {(a.x + b.x + c.x) * third, (a.y + b.y + c.y) * third, (a.z + b.z + c.z) * third};
}

// A corner of the polygon next to which a point inside is easy to find: O'Rourke, Computational Geometry in C,
// section 1.4.
class RegionInterior {
 public:
  RegionInterior(const Sheets& sheets, std::uint32_t region) : table_(sheets.scene->table), cut_(*sheets.subdivision) {
    const std::uint32_t facet = cut_.region_facet[region];
    axis_ = table_.main_axis(PlaneId{facet});
    positive_ = table_.normal_component(PlaneId{facet}, axis_) == Sign::positive;
    first_loop_ = cut_.region_first_loop[region];
    end_loop_ = cut_.region_first_loop[region + 1];
  }

  RationalPoint3 point() const {
    const auto [a, v, b] = convex_corner();
    const RationalPoint3 pa = table_.exact(a);
    const RationalPoint3 pv = table_.exact(v);
    const RationalPoint3 pb = table_.exact(b);
    Rational best(0.0);
    PointId deepest;
    for (std::uint32_t l = first_loop_; l < end_loop_; ++l) {
      for (const PointId w : cut_.loop(l)) {
        if (w == a || w == v || w == b) continue;
        const RationalPoint3 pw = table_.exact(w);
        const Rational depth = left(pb, pa, pw);
        if (depth.sign() == Sign::negative || left(pa, pv, pw).sign() == Sign::negative ||
            left(pv, pb, pw).sign() == Sign::negative) {
          continue;
        }
        if (deepest.is_none() || depth > best) {
          best = depth;
          deepest = w;
        }
      }
    }
    return deepest.is_none() ? mean(pa, pv, pb) : mean(pv, table_.exact(deepest));
  }

 private:
  // Twice the area to the left of a, b, c.
  Rational left(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c) const {
    const Rational area = cross(a, b, c, axis_);
    return positive_ ? area : -area;
  }

  bool less(PointId p, PointId q) const {
    const Sign first = table_.compare(p, q, (axis_ + 1) % 3);
    if (first != Sign::zero) return first == Sign::negative;
    return table_.compare(p, q, (axis_ + 2) % 3) == Sign::negative;
  }

  // At the lexicographically smallest vertex of the outer loop: one of its passes turns left.
  std::array<PointId, 3> convex_corner() const {
    const std::span<const PointId> loop = cut_.loop(first_loop_);
    PointId smallest = loop[0];
    for (const PointId p : loop) {
      if (p != smallest && less(p, smallest)) smallest = p;
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop[i] != smallest) continue;
      const PointId before = loop[i == 0 ? loop.size() - 1 : i - 1];
      const PointId after = loop[i + 1 == loop.size() ? 0 : i + 1];
      if (left(table_.exact(before), table_.exact(smallest), table_.exact(after)).sign() == Sign::positive) {
        return {before, smallest, after};
      }
    }
    throw InternalError("a region of the overlay has no convex corner");
  }

  const Constructions& table_;
  const Subdivision& cut_;
  unsigned axis_;
  bool positive_;
  std::uint32_t first_loop_;
  std::uint32_t end_loop_;
};

double rounded(const Rational& value) {
  return value.to_double();
}

// The line through a point along an axis, against tiles. Coordinates u and v are the other two.
class LineThroughPoint {
 public:
  LineThroughPoint(const Constructions& table, const RationalPoint3& point, unsigned axis)
      : table_(table), exact_(point), rounded_{rounded(point.x), rounded(point.y), rounded(point.z)}, axis_(axis) {}

  const Point3& near() const { return rounded_; }

  /// +1 or -1 when the tile lies above the point and its normal points up or down, else 0.
  int above(const Corners& tile) const {
    bool inside = false;
    for (std::size_t k = 0; k < 3; ++k) {
      if (ray_crosses(tile[k], tile[(k + 1) % 3])) inside = !inside;
    }
    if (!inside) return 0;
    const Sign up = table_.turn(tile[0], tile[1], tile[2], axis_);
    return up * side(tile) == Sign::negative ? to_int(up) : 0;
  }

 private:
  // Whether the coordinate of p is larger than the point's; rounding is monotone.
  bool is_after(PointId p, unsigned axis) const {
    const double x = table_.rounded(p)[axis];
    if (x != rounded_[axis]) return x > rounded_[axis];
    return coordinate(table_.exact(p), axis) > coordinate(exact_, axis);
  }

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
    const unsigned u = (axis_ + 1) % 3;
    const unsigned v = (axis_ + 2) % 3;
    const Point3& p = table_.rounded(a);
    const Point3& q = table_.rounded(b);
    const double du = q[u] - p[u];
    const double dv = q[v] - p[v];
    const double eu = rounded_[u] - p[u];
    const double ev = rounded_[v] - p[v];
    const double area = du * ev - dv * eu;
    // Every coordinate is off by at most unit * size, every difference by 4 unit * size; two products of differences
    // of at most `reach` then by 4 * 4 unit * size * reach, and their own roundings by 4 unit * reach^2 <= 8 unit *
    // size * reach.
    const double size = std::max({std::fabs(p[u]), std::fabs(p[v]), std::fabs(q[u]), std::fabs(q[v]),
                                  std::fabs(rounded_[u]), std::fabs(rounded_[v])});
    const double reach = std::max({std::fabs(du), std::fabs(dv), std::fabs(eu), std::fabs(ev)}) + 4 * unit * size;
    if (in_range(size) && std::fabs(area) > 32 * unit * size * reach) return sign_of(area);
    const RationalPoint3 pa = table_.exact(a);
    const RationalPoint3 pb = table_.exact(b);
    const Sign sign = cross(pa, pb, exact_, axis_).sign();
    if (sign != Sign::zero) return sign;
    const Sign rise = (coordinate(pb, v) - coordinate(pa, v)).sign();
    if (rise != Sign::zero) return -rise;
    return (coordinate(pb, u) - coordinate(pa, u)).sign();
  }

  // Side of the tile's plane on which the point lies.
  Sign side(const Corners& tile) const {
    std::array<Point3, 3> d;
    double size = std::max({std::fabs(rounded_.x), std::fabs(rounded_.y), std::fabs(rounded_.z)});
    double reach = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& p = table_.rounded(tile[k]);
      d[k] = {p.x - rounded_.x, p.y - rounded_.y, p.z - rounded_.z};
      size = std::max({size, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
      reach = std::max({reach, std::fabs(d[k].x), std::fabs(d[k].y), std::fabs(d[k].z)});
    }
    const double det = d[0].x * (d[1].y * d[2].z - d[1].z * d[2].y) + d[0].y * (d[1].z * d[2].x - d[1].x * d[2].z) +
                       d[0].z * (d[1].x * d[2].y - d[1].y * d[2].x);
    // Entries are off by at most 4 unit * size; six products of three: 6 * 3 * 4 unit * size * reach^2, and their own
    // roundings by 6 * 6 unit * reach^3 <= 72 unit * size * reach^2.
    reach += 4 * unit * size;
    if (in_range(size) && std::fabs(det) > 160 * unit * size * reach * reach) return -sign_of(det);
    const RationalPoint3 a = table_.exact(tile[0]);
    const RationalPoint3 b = table_.exact(tile[1]);
    const RationalPoint3 c = table_.exact(tile[2]);
    const Rational exact_det = (exact_.x - a.x) * cross(a, b, c, 0) + (exact_.y - a.y) * cross(a, b, c, 1) +
                               (exact_.z - a.z) * cross(a, b, c, 2);
    return exact_det.sign();
  }

  // No product of the filters above under- or overflows harmfully.
  static bool in_range(double size) { return size > 1e-60 && size < 1e90; }

  const Constructions& table_;
  RationalPoint3 exact_;
  Point3 rounded_;
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
  if (sheets.is_region(sheet)) return RegionInterior(sheets, sheets.region(sheet)).point();
  const Corners corners = sheets.corners(sheet);
  const Constructions& table = sheets.scene->table;
  return mean(table.exact(corners[0]), table.exact(corners[1]), table.exact(corners[2]));
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
