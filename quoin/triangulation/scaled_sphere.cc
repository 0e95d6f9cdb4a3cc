// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/scaled_sphere.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "quoin/number/fixed_int.h"

namespace quoin::detail {

namespace {

// Differences are below D = 2^61 in magnitude. Numbers are kept in limbs of 62 bits, all but the highest not negative,
// so that each product is one signed multiplication, and a column of sums of products needs no carries until the end:
// of degree 2 (minors below 2 D^2, lifts below 3 D^2 < 2^124) two limbs, of degree 3 (below 6 D^3 < 2^186) three.
constexpr int limb_bits = 62;
constexpr double largest_coordinate = 0x1p61;
constexpr std::uint64_t bound_of_differences = std::uint64_t{1} << 61;

using fixed_int_detail::Int128;

Int128 product(std::int64_t a, std::int64_t b) {
  return static_cast<Int128>(a) * b;
}
std::int64_t low_limb(Int128 v) {
  return static_cast<std::int64_t>(v) & ((std::int64_t{1} << limb_bits) - 1);
}
std::int64_t high_limb(Int128 v) {
  return static_cast<std::int64_t>(v >> limb_bits);
}

struct Quadratic {
  std::int64_t low;
  std::int64_t high;

  explicit Quadratic(Int128 v) : low(low_limb(v)), high(high_limb(v)) {}
};

struct Cubic {
  std::int64_t low;
  std::int64_t middle;
  std::int64_t high;

  /// Of columns.
  Cubic(Int128 first, Int128 second) : low(low_limb(first)) {
    second += first >> limb_bits;
    middle = low_limb(second);
    high = high_limb(second);
  }
};

struct Row {
  std::int64_t x;
  std::int64_t y;
  std::int64_t z;

  Quadratic lift() const { return Quadratic(product(x, x) + product(y, y) + product(z, z)); }
};

Quadratic minor(const Row& a, const Row& b) {
  return Quadratic(product(a.x, b.y) - product(b.x, a.y));
}

/// z times the minor of the other two columns, for three rows.
Cubic minor(const Row& a, const Quadratic& bc, const Row& b, const Quadratic& ac, const Row& c, const Quadratic& ab) {
  return {product(bc.low, a.z) - product(ac.low, b.z) + product(ab.low, c.z),
          product(bc.high, a.z) - product(ac.high, b.z) + product(ab.high, c.z)};
}

/// A sum of products of degree 5 by columns. Two products added and two taken away keep below 2^127, as each column has
/// at most two products of limbs of each.
class Quintic {
 public:
  void add(const Cubic& a, const Quadratic& b) {
    columns_[0] += product(a.low, b.low);
    columns_[1] += product(a.low, b.high) + product(a.middle, b.low);
    columns_[2] += product(a.middle, b.high) + product(a.high, b.low);
    columns_[3] += product(a.high, b.high);
  }
  void subtract(const Cubic& a, const Quadratic& b) {
    columns_[0] -= product(a.low, b.low);
    columns_[1] -= product(a.low, b.high) + product(a.middle, b.low);
    columns_[2] -= product(a.middle, b.high) + product(a.high, b.low);
    columns_[3] -= product(a.high, b.high);
  }
  int sign() const {
    const Int128 second = columns_[1] + (columns_[0] >> limb_bits);
    const Int128 third = columns_[2] + (second >> limb_bits);
    const Int128 highest = columns_[3] + (third >> limb_bits);
    if (highest != 0) return highest > 0 ? 1 : -1;
    return (low_limb(columns_[0]) | low_limb(second) | low_limb(third)) != 0 ? 1 : 0;
  }

 private:
  std::array<Int128, 4> columns_{};
};

using IntegerPoints = std::array<std::array<std::int64_t, 3>, 5>;

/// Whether no coordinate is too large, has a bit below the integers, or underflows. Without branches but two.
bool to_integers(const std::array<const Point3*, 5>& points, double scale, double unit, IntegerPoints& out) {
  double largest = 0;
  for (const Point3* const p : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) largest = std::max(largest, std::fabs((*p)[axis] * scale));
  }
  if (!(largest <= largest_coordinate)) return false;
  double lost = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double coordinate = (*points[i])[axis];
      out[i][axis] = static_cast<std::int64_t>(coordinate * scale);
      lost = std::max(lost, std::fabs(coordinate - static_cast<double>(out[i][axis]) * unit));
    }
  }
  return lost == 0;
}

}  // namespace

bool in_sphere_of_integers(const std::array<const Point3*, 5>& points, double scale, double unit, int& sign) {
  IntegerPoints p;
  if (!to_integers(points, scale, unit, p)) return false;
  std::uint64_t shifted = 0;
  const auto row = [&](std::size_t i) {
    const Row r{p[i][0] - p[4][0], p[i][1] - p[4][1], p[i][2] - p[4][2]};
    for (const std::int64_t v : {r.x, r.y, r.z}) shifted |= static_cast<std::uint64_t>(v) + bound_of_differences;
    return r;
  };
  const Row a = row(0);
  const Row b = row(1);
  const Row c = row(2);
  const Row d = row(3);
  if (shifted >= 2 * bound_of_differences) return false;
  const Quadratic ab = minor(a, b);
  const Quadratic ac = minor(a, c);
  const Quadratic ad = minor(a, d);
  const Quadratic bc = minor(b, c);
  const Quadratic bd = minor(b, d);
  const Quadratic cd = minor(c, d);
  Quintic sum;
  sum.add(minor(b, cd, c, bd, d, bc), a.lift());
  sum.subtract(minor(a, cd, c, ad, d, ac), b.lift());
  sum.add(minor(a, bd, b, ad, d, ab), c.lift());
  sum.subtract(minor(a, bc, b, ac, c, ab), d.lift());
  sign = sum.sign();
  return true;
}

}  // namespace quoin::detail
