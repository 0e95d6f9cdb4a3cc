// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/placed_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace quoin {

namespace {

constexpr double unit = 0x1p-53;  // half an ulp of 1

// No product of the filters below under- or overflows harmfully.
bool in_range(double size) {
  return size > 1e-60 && size < 1e90;
}

double largest(const Point3& p) {
  return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
}

}  // namespace

PlacedPoint::PlacedPoint(const Constructions& table, RationalPoint3 point)
    : table_(&table),
      exact_(std::move(point)),
      rounded_{exact_.x.to_double(), exact_.y.to_double(), exact_.z.to_double()} {}

// Rounding is monotone, so different rounded coordinates decide.
Sign PlacedPoint::compare(PointId p, unsigned axis) const {
  const double x = table_->rounded(p)[axis];
  if (x != rounded_[axis]) return x > rounded_[axis] ? Sign::positive : Sign::negative;
  return (table_->exact(p)[axis] - exact_[axis]).sign();
}

bool PlacedPoint::equals(PointId p) const {
  const Point3& x = table_->rounded(p);
  return x.x == rounded_.x && x.y == rounded_.y && x.z == rounded_.z && table_->exact(p) == exact_;
}

Sign PlacedPoint::turn(PointId a, PointId b, unsigned axis) const {
  const unsigned u = (axis + 1) % 3;
  const unsigned v = (axis + 2) % 3;
  const Point3& p = table_->rounded(a);
  const Point3& q = table_->rounded(b);
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
  return projected_area(table_->exact(a), table_->exact(b), exact_, axis).sign();
}

Sign PlacedPoint::side(PointId a, PointId b, PointId c) const {
  std::array<Point3, 3> d;
  const std::array<PointId, 3> corners{a, b, c};
  double size = largest(rounded_);
  double reach = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3& p = table_->rounded(corners[k]);
    d[k] = {p.x - rounded_.x, p.y - rounded_.y, p.z - rounded_.z};
    size = std::max(size, largest(p));
    reach = std::max(reach, largest(d[k]));
  }
  const double det = d[0].x * (d[1].y * d[2].z - d[1].z * d[2].y) + d[0].y * (d[1].z * d[2].x - d[1].x * d[2].z) +
                     d[0].z * (d[1].x * d[2].y - d[1].y * d[2].x);
  // Entries are off by at most 4 unit * size; six products of three: 6 * 3 * 4 unit * size * reach^2, and their own
  // roundings by 6 * 6 unit * reach^3 <= 72 unit * size * reach^2.
  reach += 4 * unit * size;
  if (in_range(size) && std::fabs(det) > 160 * unit * size * reach * reach) return -sign_of(det);
  const RationalPoint3 origin = table_->exact(a);
  return dot(cross(table_->exact(b) - origin, table_->exact(c) - origin), exact_ - origin).sign();
}

}  // namespace quoin
