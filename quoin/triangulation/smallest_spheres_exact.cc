// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "quoin/number/bounded_int.h"
#include "quoin/triangulation/grid_integers.h"
#include "quoin/triangulation/smallest_spheres.h"
#include "quoin/triangulation/sphere_formulas.h"

namespace quoin {

namespace {

using FixedRow = sphere_formulas::Row<BoundedInt<62>, BoundedInt<126>>;
using IntegerRow = sphere_formulas::Row<Integer>;

std::array<double, 3> coordinates(const Point3& p) {
  return {p.x, p.y, p.z};
}

/// Coordinates times the scale, where they are integers below 2^61.
bool to_integers(const Point3& p, double scale, std::array<std::int64_t, 3>& out) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double scaled = p[axis] * scale;
    if (!(std::fabs(scaled) < 0x1p61)) return false;
    out[axis] = static_cast<std::int64_t>(scaled);
    // What vanishes without being zero has underflowed.
    if (static_cast<double>(out[axis]) != scaled || (out[axis] == 0 && p[axis] != 0)) return false;
  }
  return true;
}

/// A simplex by rows from its first point, in units of a power of two.
struct IntegerSimplex {
  std::array<IntegerRow, 3> rows;
  Integer weight;  ///< of the first, in units of 4^lo
  int lo = 0;

  IntegerSimplex(const SmallestSpheres& spheres, SmallestSpheres::Simplex simplex) {
    std::array<double, 12> values{};
    std::array<double, 4> weights{};
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      const Point3& p = spheres.point(simplex[i]);
      std::copy_n(coordinates(p).begin(), 3, values.begin() + static_cast<std::ptrdiff_t>(3 * i));
      weights[i] = spheres.weight(simplex[i]);
    }
    lo = detail::CallGrid(values).lo;
    const detail::CallGrid grid_of_weights(weights);
    if (grid_of_weights.bits > 0) lo = std::min(lo, grid_of_weights.lo >> 1);
    weight = detail::on_grid(weights[0], 2 * lo);
    for (std::size_t i = 1; i < simplex.size(); ++i) {
      IntegerRow& row = rows[i - 1];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        row.vector[axis] = detail::on_grid(values[3 * i + axis], lo) - detail::on_grid(values[axis], lo);
      }
      row.lift = sphere_formulas::dot(row.vector, row.vector) + weight - detail::on_grid(weights[i], 2 * lo);
    }
  }
};

bool to_fixed_rows(const SmallestSpheres& spheres, SmallestSpheres::Simplex simplex, double scale,
                   std::array<FixedRow, 3>& rows) {
  if (spheres.is_weighted() || scale == 0) return false;
  std::array<std::int64_t, 3> origin{};
  if (!to_integers(spheres.point(simplex[0]), scale, origin)) return false;
  for (std::size_t i = 1; i < simplex.size(); ++i) {
    std::array<std::int64_t, 3> p{};
    if (!to_integers(spheres.point(simplex[i]), scale, p)) return false;
    FixedRow& row = rows[i - 1];
    for (std::size_t axis = 0; axis < 3; ++axis) row.vector[axis] = BoundedInt<62>(p[axis] - origin[axis]);
    row.lift = sphere_formulas::dot(row.vector, row.vector);
  }
  return true;
}

/// take(numerator, denominator) of 4 |x|^2.
template <class R, class Take>
auto with_centre_square(const std::array<R, 3>& rows, std::size_t count, const Take& take) {
  if (count == 1) {
    const auto q = sphere_formulas::centre_square(rows[0]);
    return take(q.numerator, q.denominator);
  }
  if (count == 2) {
    const auto q = sphere_formulas::centre_square(rows[0], rows[1]);
    return take(q.numerator, q.denominator);
  }
  const auto q = sphere_formulas::centre_square(rows[0], rows[1], rows[2]);
  return take(q.numerator, q.denominator);
}

template <class R>
Sign excess_sign(const std::array<R, 3>& rows, std::size_t count) {
  if (count == 1) return sphere_formulas::excess(rows[0]).sign();
  if (count == 2) return sphere_formulas::excess(rows[0], rows[1]).sign();
  return sphere_formulas::excess(rows[0], rows[1], rows[2]).sign();
}

/// Of a quotient of positive numbers: two mantissas that were rounded, and a division.
Interval around_quotient(const LeadingBits& numerator, const LeadingBits& denominator, std::int64_t exponent) {
  const double quotient = nearest_mantissa(numerator) / nearest_mantissa(denominator);
  exponent += numerator.exponent - denominator.exponent;
  if (exponent < -1000 || exponent > 1000) return Interval::unbounded();
  const double value = std::ldexp(quotient, static_cast<int>(exponent));
  return {value * (1 - 0x1p-51), value * (1 + 0x1p-51)};
}

/// The nearest double to the same quotient, where 64 bits of both and of the quotient tell it.
std::optional<double> nearest_to_quotient(const LeadingBits& numerator, const LeadingBits& denominator,
                                          std::int64_t exponent) {
  // In [2^63, 2^65), 4 units or less from the quotient: each of numerator and denominator misses less than one in 2^63,
  // and the division less than one.
  using Wide = fixed_int_detail::UInt128;
  const Wide quotient = (static_cast<Wide>(numerator.bits) << 64) / denominator.bits;
  exponent += numerator.exponent - denominator.exponent - 64;
  if (exponent < -1000 || exponent > 900) return std::nullopt;
  const auto round = [](Wide x) {
    const auto sticky = static_cast<std::uint64_t>((x & 7) != 0);
    return static_cast<double>(static_cast<std::int64_t>(static_cast<std::uint64_t>(x >> 3) | sticky));
  };
  const double below = round(quotient - 4);
  if (below != round(quotient + 4)) return std::nullopt;
  return std::ldexp(below, static_cast<int>(exponent) + 3);
}

int exponent_of(double power_of_two) {
  return std::ilogb(power_of_two);
}

}  // namespace

Rational ExactQuotient::rational() const {
  const auto bits = static_cast<std::size_t>(std::abs(exponent));
  return exponent < 0 ? Rational(numerator, denominator << bits) : Rational(numerator << bits, denominator);
}

Interval ExactQuotient::interval() const {
  if (numerator.sign() == Sign::zero) return {0};
  const Interval size = around_quotient(leading_bits(numerator), leading_bits(denominator), exponent);
  if (!size.contains(0)) return numerator.sign() == Sign::positive ? size : -size;
  return Interval::around(rational());
}

Integer ExactQuotient::scaled_floor(int shift) const {
  const int bits = exponent + shift;
  if (bits >= 0) return floor_quotient(numerator << static_cast<std::size_t>(bits), denominator);
  return floor_quotient(numerator, denominator << static_cast<std::size_t>(-bits));
}

Sign compare(const ExactQuotient& a, const ExactQuotient& b) {
  Integer left = a.numerator * b.denominator;
  Integer right = b.numerator * a.denominator;
  if (a.exponent > b.exponent) left <<= static_cast<std::size_t>(a.exponent - b.exponent);
  if (b.exponent > a.exponent) right <<= static_cast<std::size_t>(b.exponent - a.exponent);
  return (left - right).sign();
}

ExactQuotient SmallestSpheres::exact_power(Simplex simplex) const {
  if (simplex.size() == 1) {
    const detail::Parts parts = detail::parts_of(weight(simplex[0]));
    return {Integer(-parts.mantissa), Integer(1), parts.exponent};
  }
  if (std::array<FixedRow, 3> rows; to_fixed_rows(*this, simplex, scale_, rows)) {
    return with_centre_square(rows, simplex.size() - 1, [&](const auto& numerator, const auto& denominator) {
      return ExactQuotient{to_integer(numerator.limbs()), to_integer(denominator.limbs()) << 2,
                           -2 * exponent_of(scale_)};
    });
  }
  const IntegerSimplex exact(*this, simplex);
  return with_centre_square(exact.rows, simplex.size() - 1, [&](const Integer& numerator, const Integer& denominator) {
    const Integer divisor = denominator << 2;
    return ExactQuotient{numerator - exact.weight * divisor, divisor, 2 * exact.lo};
  });
}

Interval SmallestSpheres::close_power(Simplex simplex) const {
  if (simplex.size() == 1) return {-weight(simplex[0])};
  if (std::array<FixedRow, 3> rows; to_fixed_rows(*this, simplex, scale_, rows)) {
    const Interval quick =
        with_centre_square(rows, simplex.size() - 1, [&](const auto& numerator, const auto& denominator) {
          return around_quotient(leading_bits(numerator.limbs()), leading_bits(denominator.limbs()),
                                 -2 - 2 * exponent_of(scale_));
        });
    if (!quick.contains(0)) return quick;
  }
  return exact_power(simplex).interval();
}

double SmallestSpheres::nearest_power(Simplex simplex) const {
  if (const Interval quick = power(simplex); quick.is_point()) return quick.lower();
  if (std::array<FixedRow, 3> rows; to_fixed_rows(*this, simplex, scale_, rows)) {
    const std::optional<double> quick =
        with_centre_square(rows, simplex.size() - 1, [&](const auto& numerator, const auto& denominator) {
          return nearest_to_quotient(leading_bits(numerator.limbs()), leading_bits(denominator.limbs()),
                                     -2 - 2 * exponent_of(scale_));
        });
    if (quick) return *quick;
  }
  return exact_power(simplex).nearest();
}

Sign SmallestSpheres::exact_side(Simplex facet, std::uint32_t q) const {
  std::array<std::uint32_t, 4> all{};
  std::copy(facet.begin(), facet.end(), all.begin());
  all[facet.size()] = q;
  const Simplex simplex(all.data(), facet.size() + 1);
  if (std::array<FixedRow, 3> rows; to_fixed_rows(*this, simplex, scale_, rows)) {
    return excess_sign(rows, facet.size());
  }
  return excess_sign(IntegerSimplex(*this, simplex).rows, facet.size());
}

}  // namespace quoin
