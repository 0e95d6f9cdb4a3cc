// SPDX-License-Identifier: Apache-2.0
// Supports and points of the geodesic family: their definitions and their certified doubles.
//
// With u = 2^-53, the components of a support's normal are true ones times a common power of two, each with a relative
// error of at most u, and zero exactly where the true one is. A point has the components of its direction with a
// relative error of at most d up to a common factor:
//  - a direction of the input, or a crossing placed from exact integers: d = 2 u (rounded once, divided once);
//  - a crossing placed from rounded normals: a component t = a b - c d, rounded three times, of factors with an error
//    of u, has an absolute error below 4.01 u (|a b| + |c d|); it is accepted only where that sum is at most 2^7 |t|,
//    so d <= 2^-43.9 + u.
// The length is found with a relative error of 4 u, common to all components, beyond d: the unit vector is within
// 2 d + 6 u < 2^-42.8 in each coordinate, below error(). A folded y / (|x| + |y|) has an error of at most d / 2 from
// its arguments and 5 u from rounding, below key_error(). A scalar product with a normal, |n| <= sqrt 3, has an error
// of at most sqrt 3 (d + u + 4 u): below 2^-43 for crossings, 2^-49.3 for directions; what underflows is far below.
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "quoin/arrangement/geodesic/geodesic_exact.h"
#include "quoin/arrangement/geodesic/geodesic_family.h"

namespace quoin {
namespace {

using geodesic_exact::with_tier;

/// A number rounded to mantissa 2^exponent; the mantissa is zero or in [2^63, 2^64] in magnitude.
struct Rounded {
  double mantissa = 0;
  std::int64_t exponent = 0;
};

template <class Number>
Rounded rounded(const Number& value) {
  const Sign sign = value.sign();
  if (sign == Sign::zero) return {};
  const LeadingBits leading = leading_bits(value);
  return {to_int(sign) * nearest_mantissa(leading), leading.exponent};
}

/// a 2^shift, never zero by underflow.
double scaled(const Rounded& a, std::int64_t shift) {
  if (a.mantissa == 0) return 0;
  const std::int64_t exponent = a.exponent + shift;
  if (exponent > -1000 && exponent < 900) {
    return a.mantissa * std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
  }
  const double value = std::ldexp(a.mantissa, static_cast<int>(std::max<std::int64_t>(exponent, -4000)));
  return value != 0 ? value : std::copysign(0x1p-1074, a.mantissa);
}

/// Monotone in the angle of (x, y) in (-pi, pi], from -2 to 2; not both are zero.
double folded_angle(double x, double y) {
  const double t = y / (std::fabs(x) + std::fabs(y));
  if (x >= 0) return t;
  return y >= 0 ? 2 - t : -2 - t;
}

/// Components with a common scale, the largest in [1/2, 1]. One of them is not zero.
Vector3 common_scale(const std::array<Rounded, 3>& c) {
  std::int64_t highest = INT64_MIN;
  for (const Rounded& part : c) {
    if (part.mantissa != 0) highest = std::max(highest, part.exponent);
  }
  return {scaled(c[0], -highest - 64), scaled(c[1], -highest - 64), scaled(c[2], -highest - 64)};
}

/// Nonzero components stay nonzero.
Vector3 normalised(const Vector3& v) {
  const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  const auto divide = [length](double value) {
    const double quotient = value / length;
    return quotient != 0 || value == 0 ? quotient : std::copysign(0x1p-1074, value);
  };
  return {divide(v.x), divide(v.y), divide(v.z)};
}

/// a b - c d, if its relative error is certified. A factor of a normal is zero only where it truly is.
bool difference_of_products(double a, double b, double c, double d, double& out) {
  const double ab = a * b;
  const double cd = c * d;
  out = ab - cd;
  const double size = std::fabs(out);
  if (size >= 0x1p-900) return std::fabs(ab) + std::fabs(cd) <= 0x1p7 * size;
  return out == 0 && (a == 0 || b == 0) && (c == 0 || d == 0);
}

}  // namespace

std::uint32_t GeodesicFamily::add_support(const SphereDirection& canonical) {
  return settle_support(make_support(normals_.append(canonical)));
}

std::uint32_t GeodesicFamily::settle_support(const Support& added) {
  const auto last = static_cast<std::uint32_t>(supports_.size());
  supports_.push_back(added);
  const std::uint32_t known = planes_.find(added.normal, [&](std::uint32_t i) { return are_parallel(i, last); });
  if (known == PlaneIndex::none) {
    planes_.add(added.normal, last);
    return last;
  }
  supports_.pop_back();
  normals_.remove_last();
  return known;
}

bool GeodesicFamily::are_parallel(std::uint32_t a, std::uint32_t b) const {
  if (normals_.has_same_integers(a, b)) return true;
  return with_tier(std::max(supports_[a].tier, supports_[b].tier), [&]<class Tier>(Tier) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (geodesic_exact::cross_component<Tier>(normals_, a, b, axis).sign() != Sign::zero) return false;
    }
    return true;
  });
}

GeodesicFamily::Support GeodesicFamily::make_support(std::uint32_t index) const {
  Support added;
  added.tier = geodesic_exact::tier_of_normal(normals_.bits(index));
  added.is_vertical = normals_.sign(index, 2) == Sign::zero;
  added.normal = with_tier(added.tier, [&]<class Tier>(Tier) {
    std::array<Rounded, 3> c;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      c[axis] = rounded(geodesic_exact::normal_component<Tier>(normals_, index, axis));
    }
    return common_scale(c);
  });
  return added;
}

void GeodesicFamily::set_column(Point& p, Side side) {
  if (!is_on_identification(p.approximate)) return;
  p.column = side == Side::right ? 1 : -1;
  p.longitude_key = 2.0 * p.column;
  if (p.side != Side::bottom && p.side != Side::top) p.side = side;
}

GeodesicFamily::Point GeodesicFamily::on_side(Point p, Side side) {
  set_column(p, side);
  return p;
}

void GeodesicFamily::place_exact(Point& p) const {
  std::array<Rounded, 3> c;
  with_tier(p.tier, [&]<class Tier>(Tier) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      c[axis] = rounded(geodesic_exact::coordinate<Tier>(normals_, directions_, p, axis));
    }
  });
  const Vector3 v = common_scale(c);
  p.approximate = normalised(v);
  if (std::max(std::fabs(v.x), std::fabs(v.y)) > 0x1p-900) {
    p.longitude_key = folded_angle(v.x, v.y);
  } else if (!is_at_pole(v)) {
    c[2] = {};
    const Vector3 horizontal = common_scale(c);
    p.longitude_key = folded_angle(horizontal.x, horizontal.y);
  }
  set_column(p, Side::left);
}

bool GeodesicFamily::place_filtered(Point& p, const Vector3& a, const Vector3& b) const {
  Vector3 c;
  const bool certain = difference_of_products(a.y, b.z, a.z, b.y, c.x) &&
                       difference_of_products(a.z, b.x, a.x, b.z, c.y) &&
                       difference_of_products(a.x, b.y, a.y, b.x, c.z);
  const double size = c.x * c.x + c.y * c.y + c.z * c.z;
  if (!certain || size < 0x1p-100) return false;
  const double length = std::sqrt(size);
  p.approximate = {c.x / length, c.y / length, c.z / length};
  p.longitude_key = folded_angle(c.x, c.y);
  set_column(p, Side::left);
  return true;
}

GeodesicFamily::Point GeodesicFamily::direction_point(const SphereDirection& direction) {
  Point p;
  p.first = directions_.insert(direction);
  p.tier = geodesic_exact::tier_of_direction(directions_.bits(p.first));
  place_exact(p);
  return p;
}

GeodesicFamily::Point GeodesicFamily::crossing(std::uint32_t a, std::uint32_t b) const {
  Point p;
  p.first = std::min(a, b);
  p.second = std::max(a, b);
  p.sign = a < b ? 1 : -1;
  p.tier = std::max(supports_[a].tier, supports_[b].tier);
  if (!place_filtered(p, supports_[a].normal, supports_[b].normal)) place_exact(p);
  return p;
}

/// The opposite point of a crossing; on the identification its left copy. Of doubles only the longitude changes.
GeodesicFamily::Point GeodesicFamily::antipode(const Point& p) {
  Point q(p);
  q.sign = static_cast<std::int8_t>(-p.sign);
  q.approximate = {-p.approximate.x, -p.approximate.y, -p.approximate.z};
  if (p.approximate.y == 0) {
    q.longitude_key = 0;
  } else {
    q.longitude_key += p.approximate.y < 0 ? 2 : -2;
  }
  q.side = Side::interior;
  q.column = 0;
  set_column(q, Side::left);
  return q;
}

GeodesicFamily::Point GeodesicFamily::pole_end(const SphereDirection& horizontal, Side side) {
  Point p = direction_point(horizontal);
  p.side = side;
  return p;
}

GeodesicFamily::Point GeodesicFamily::left_copy(const Point& p) const {
  return p.side == Side::right ? on_side(p, Side::left) : p;
}

Vector3 GeodesicFamily::position(const Point& p) const {
  if (p.side == Side::bottom) return {0, 0, -1};
  if (p.side == Side::top) return {0, 0, 1};
  return p.approximate;
}

std::array<Integer, 3> GeodesicFamily::direction(const Point& p) const {
  if (level(p) != 0) return {Integer(), Integer(), Integer(level(p))};
  std::array<Integer, 3> c;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    c[axis] = geodesic_exact::coordinate<geodesic_exact::AnySizeTier>(normals_, directions_, p, axis);
  }
  return SphereDirection(c).primitive().integers();
}

std::array<Integer, 3> GeodesicFamily::normal(BranchId b) const {
  std::array<Integer, 3> n;
  for (std::size_t axis = 0; axis < 3; ++axis) normals_.load(support(b), axis, n[axis]);
  if (is_vertical(b) && !is_second_half(b)) n = {-n[0], -n[1], -n[2]};
  return SphereDirection(n).primitive().integers();
}

GeodesicFamily::Shift GeodesicFamily::absorb(const GeodesicFamily& other) {
  Shift shift;
  const std::size_t count = other.supports_.size();
  for (std::size_t i = 0; i < count; ++i) {
    normals_.append(other.normals_, static_cast<std::uint32_t>(i));
    shift.supports.push_back(settle_support(Support(other.supports_[i])));
    shift.tiers.push_back(supports_[shift.supports.back()].tier);
  }
  shift.directions = directions_.absorb(other.directions_);
  return shift;
}

GeodesicFamily::Point GeodesicFamily::shifted(const Point& p, const Shift& shift) {
  Point q(p);
  if (!p.is_crossing()) {
    q.first = shift.directions[p.first];
    return q;
  }
  q.first = shift.supports[p.first];
  q.second = shift.supports[p.second];
  q.tier = std::max(shift.tiers[p.first], shift.tiers[p.second]);
  if (q.first > q.second) {
    std::swap(q.first, q.second);
    q.sign = static_cast<std::int8_t>(-q.sign);
  }
  return q;
}

BranchId GeodesicFamily::shifted(BranchId b, const Shift& shift) {
  return branch(shift.supports[support(b)], is_second_half(b));
}

std::vector<Vector3> GeodesicFamily::flatten(BranchId b, const Point& left, const Point& right,
                                             double max_angle) const {
  constexpr double pi = 3.14159265358979323846;
  const Vector3 a = position(left);
  const Vector3 z = position(right);
  Vector3 n = normalised(supports_[support(b)].normal);
  if (is_vertical(b) && !is_second_half(b)) n = {-n.x, -n.y, -n.z};
  const Vector3 side{n.y * a.z - n.z * a.y, n.z * a.x - n.x * a.z, n.x * a.y - n.y * a.x};
  const double cosine = a.x * z.x + a.y * z.y + a.z * z.z;
  double angle = std::atan2(side.x * z.x + side.y * z.y + side.z * z.z, cosine);
  if (angle < 0) angle += 2 * pi;
  // The turn is more than half of one exactly where the longitudes differ by more than pi; that tells 0 from 2 pi.
  const bool is_long = right.longitude_key - left.longitude_key > 2;
  if (is_long && angle < 1) angle = 2 * pi;
  if (!is_long && angle > 2 * pi - 1) angle = 0;
  const double step = max_angle > 1e-4 ? max_angle : 1e-4;
  const auto count = static_cast<std::size_t>(std::ceil(angle / step));
  std::vector<Vector3> result{a};
  for (std::size_t i = 1; i < count; ++i) {
    const double t = angle * static_cast<double>(i) / static_cast<double>(count);
    const double c = std::cos(t);
    const double s = std::sin(t);
    result.push_back(normalised({c * a.x + s * side.x, c * a.y + s * side.y, c * a.z + s * side.z}));
  }
  result.push_back(z);
  return result;
}

}  // namespace quoin
