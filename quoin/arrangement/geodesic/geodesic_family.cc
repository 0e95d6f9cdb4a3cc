// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/geodesic/geodesic_family.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "quoin/arrangement/geodesic/geodesic_exact.h"

namespace quoin {

using geodesic_exact::with_tier;

static_assert(IdentifiedFamily<GeodesicFamily>);
static_assert(sizeof(GeodesicFamily::Point) <= 48);

/// Of points of one column with keys that do not differ for certain: so less than half a turn lies between them.
Sign GeodesicFamily::compare_close(const Point& p, const Point& q) const {
  if (p.same_definition(q)) return Sign::zero;
  if (p.column == 0) {
    const Sign order = compare_longitude_exact(p, q);
    if (order != Sign::zero) return order;
  }
  if (level(p) != 0 || level(q) != 0) return sign_of(level(p) - level(q));
  return compare_latitude(p, q);
}

Sign GeodesicFamily::compare_longitude_exact(const Point& p, const Point& q) const {
  return with_tier(std::max(p.tier, q.tier), [&]<class Tier>(Tier) {
    return -geodesic_exact::determinant_sign<Tier>(normals_, directions_, p, q, 0, 1);
  });
}

/// Of interior points of one meridian: with horizontal parts of one direction, v orders like z over either coordinate's
/// magnitude.
Sign GeodesicFamily::compare_latitude(const Point& p, const Point& q) const {
  const double difference = p.approximate.z - q.approximate.z;
  if (std::fabs(difference) > 2 * error()) return sign_of(difference);
  const std::size_t axis = p.approximate.x != 0 ? 0 : 1;
  const Sign order = with_tier(std::max(p.tier, q.tier), [&]<class Tier>(Tier) {
    return geodesic_exact::determinant_sign<Tier>(normals_, directions_, p, q, 2, axis);
  });
  return sign_of(p.approximate[axis]) * order;
}

Sign GeodesicFamily::compare_y_at_x_exact(const Point& p, BranchId b) const {
  if (p.is_crossing_of(support(b))) return Sign::zero;
  return with_tier(std::max(p.tier, supports_[support(b)].tier), [&]<class Tier>(Tier) {
    return geodesic_exact::scalar_product_sign<Tier>(normals_, directions_, support(b), p);
  });
}

/// Of a pole end, or beside a vertical branch.
Sign GeodesicFamily::side_at_pole(const Point& p, BranchId b) const {
  return is_vertical(b) ? Sign::zero : sign_of(level(p));
}

Sign GeodesicFamily::compare_right(BranchId b, BranchId c, const Point& p) const {
  if (same_plane(b, c)) return Sign::zero;
  if (is_vertical(b)) return is_vertical(c) ? Sign::zero : Sign::positive;
  if (is_vertical(c)) return Sign::negative;
  const std::uint32_t m = support(b);
  const std::uint32_t n = support(c);
  if (p.is_crossing_of(m) && p.is_crossing_of(n)) {
    // The sign of p . (n_c x n_b), with p = sign (n_first x n_second).
    return sign_of(m == p.first ? -p.sign : p.sign);
  }
  return compare_slopes(m, n, p);
}

/// Sign of p . (n_b x n_a) for distinct circles a and b through p: the vectors are parallel, so one component of each
/// tells.
Sign GeodesicFamily::compare_slopes(std::uint32_t a, std::uint32_t b, const Point& p) const {
  const Vector3& v = p.approximate;
  const double x = std::fabs(v.x);
  const double y = std::fabs(v.y);
  const double z = std::fabs(v.z);
  const std::size_t axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  const std::size_t j = (axis + 1) % 3;
  const std::size_t k = (axis + 2) % 3;
  const Vector3& m = supports_[a].normal;
  const Vector3& n = supports_[b].normal;
  const double component = n[j] * m[k] - n[k] * m[j];
  Sign sign;
  if (std::fabs(component) > 0x1p-49) {  // four roundings of products of at most 1: 9 2^-53
    sign = sign_of(component);
  } else {
    sign = with_tier(std::max(supports_[a].tier, supports_[b].tier), [&]<class Tier>(Tier) {
      return geodesic_exact::cross_component<Tier>(normals_, b, a, axis).sign();
    });
  }
  return sign * sign_of(v[axis]);
}

/// Moving right, `lower` goes above `upper` only at n_upper x n_lower, and below again at the opposite point half a
/// turn later. Where less than half a turn is left until the first end, the side of that end decides.
bool GeodesicFamily::first_meeting(BranchId lower, const Point& lower_end, BranchId upper, const Point& upper_end,
                                   const Point& after, Point& out) const {
  if (is_vertical(lower)) return first_meeting_vertical(lower, lower_end, upper, upper_end, after, out);
  if (is_vertical(upper)) return first_meeting_vertical(upper, upper_end, lower, lower_end, after, out);
  if (same_plane(lower, upper)) return false;
  const bool lower_is_first = compare_xy(lower_end, upper_end) != Sign::positive;
  const Point& end = lower_is_first ? lower_end : upper_end;
  if (end.longitude_key - after.longitude_key < 2 - 4 * key_error()) {
    const Sign side = compare_y_at_x(end, lower_is_first ? upper : lower);
    if (side != (lower_is_first ? Sign::positive : Sign::negative)) return false;
    out = crossing(support(upper), support(lower));
    return true;
  }
  out = crossing(support(upper), support(lower));
  return compare_xy(after, out) == Sign::negative && compare_xy(out, end) == Sign::negative;
}

bool GeodesicFamily::first_meeting_vertical(BranchId vertical, const Point& vertical_end, BranchId other,
                                            const Point& other_end, const Point& after, Point& out) const {
  if (is_vertical(other) || compare_y_at_x(vertical_end, other) != Sign::positive) return false;
  out = vertical_meeting(vertical, other);
  return compare_xy(after, out) == Sign::negative && compare_xy(out, other_end) == Sign::negative;
}

/// n x n_up: with n_up the normal of the half meridian, about which it runs upward, and n.z > 0.
GeodesicFamily::Point GeodesicFamily::vertical_meeting(BranchId vertical, BranchId other) const {
  return is_second_half(vertical) ? crossing(support(other), support(vertical))
                                  : crossing(support(vertical), support(other));
}

void GeodesicFamily::meetings(BranchId b, BranchId c, std::vector<Meeting<Point>>& out) const {
  if (same_plane(b, c) || (is_vertical(b) && is_vertical(c))) return;
  if (is_vertical(b) || is_vertical(c)) {
    out.push_back({is_vertical(b) ? vertical_meeting(b, c) : vertical_meeting(c, b), true});
    return;
  }
  Point first = crossing(support(b), support(c));
  Point second = antipode(first);
  const Vector3& v = first.approximate;
  if (v.y > 0 || (v.y == 0 && v.x > 0)) std::swap(first, second);
  out.push_back({first, true});
  out.push_back({second, true});
  if (first.column != 0) out.push_back({on_side(first, Side::right), true});
}

}  // namespace quoin
