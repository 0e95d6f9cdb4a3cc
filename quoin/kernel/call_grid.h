// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "quoin/kernel/exact_arithmetic.h"
#include "quoin/kernel/tier.h"

/// Coordinates of one predicate call as integers: exact for all finite doubles, with no limits of the exponent.
namespace quoin::detail {

/// A double as mantissa 2^exponent.
struct Parts {
  std::int64_t mantissa;
  int exponent;
};

inline Parts parts_of(double x) {
  constexpr int fraction_bits = 52;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int field = static_cast<int>((bits >> fraction_bits) & 0x7ff);
  const std::uint64_t hidden = std::uint64_t{field != 0} << fraction_bits;
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << fraction_bits) - 1);
  const auto mantissa = static_cast<std::int64_t>(fraction | hidden);
  return {(bits >> 63) != 0 ? -mantissa : mantissa, std::max(field - 1, 0) - 1074};
}

/// The exponent of the lowest bit that is set: x is an odd multiple of that power of two. Of zero the largest integer.
inline int lowest_bit(double x) {
  if (x == 0) return std::numeric_limits<int>::max();
  const Parts parts = parts_of(x);
  return parts.exponent + std::countr_zero(static_cast<std::uint64_t>(parts.mantissa));
}

/// The coarsest power of two, 2^lo, of which all values are multiples; all are of magnitude below 2^(lo + bits).
struct CallGrid {
  int lo = 0;
  int bits = 0;

  explicit CallGrid(std::span<const double> values);
};

/// Number types for integers |X| < 2^B and polynomials of their differences, by degree.
///
/// Bits of the largest magnitude; one more holds the sign. Difference B + 1; minor of two rows of differences 2B + 3,
/// sum of three products of differences below 3 * 2^(2B + 2); minor of three rows 3 * 2^(3B + 4); in_circle, three
/// lifts below 2^(2B + 3) times minors of two: 3 * 2^(4B + 6); in_sphere, four lifts times minors of three: 36 *
/// 2^(5B + 6).
template <int B>
struct CallNumbers {
  static constexpr bool is_fixed = true;
  using Linear = FixedInt<limbs_for_bits(B + 2)>;
  using Quadratic = FixedInt<limbs_for_bits(2 * B + 5)>;
  using Cubic = FixedInt<limbs_for_bits(3 * B + 7)>;
  using Quartic = FixedInt<limbs_for_bits(4 * B + 9)>;
  using Quintic = FixedInt<limbs_for_bits(5 * B + 13)>;
};

/// All of one type that holds every value.
template <class Number>
struct UniformCallNumbers {
  static constexpr bool is_fixed = false;
  using Linear = Number;
  using Quadratic = Number;
  using Cubic = Number;
  using Quartic = Number;
  using Quintic = Number;
};
using BigCallNumbers = UniformCallNumbers<Integer>;
using RationalCallNumbers = UniformCallNumbers<Rational>;

/// Differences x - y of coordinates, in units of the grid.
template <class N>
class CallReader {
 public:
  using Numbers = N;
  explicit CallReader(const CallGrid& grid) : lo_(grid.lo) {}

  typename N::Linear operator()(double x, double y) const { return value(x) - value(y); }

 private:
  typename N::Linear value(double x) const {
    const Parts parts = parts_of(x);
    const int shift = parts.exponent - lo_;
    if (shift < 0) return typename N::Linear(parts.mantissa >> std::min(-shift, 63));  // the bits that go are zero
    if constexpr (N::is_fixed) {
      return shift_left(typename N::Linear(parts.mantissa), static_cast<std::size_t>(shift));
    } else {
      return Integer(parts.mantissa) << static_cast<std::size_t>(shift);
    }
  }

  int lo_;
};

/// In one limb: x 2^-lo is an integer below 2^61, so both products are exact; two factors, because 2^-lo may be no
/// double.
template <>
class CallReader<CallNumbers<61>> {
 public:
  using Numbers = CallNumbers<61>;
  explicit CallReader(const CallGrid& grid)
      : first_(power_of_two(-grid.lo / 2)), second_(power_of_two(-grid.lo - (-grid.lo / 2))) {}

  Numbers::Linear operator()(double x, double y) const { return Numbers::Linear(value(x) - value(y)); }

 private:
  static double power_of_two(int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
  }
  std::int64_t value(double x) const { return static_cast<std::int64_t>(x * first_ * second_); }

  double first_;
  double second_;
};

/// Sign of the formula in the narrowest numbers that hold it; the formula takes a CallReader.
template <class Formula>
Sign decide_on_grid(std::span<const double> values, Tier& tier, const Formula& formula) {
  const CallGrid grid(values);
  if (grid.bits <= 61) {
    tier = Tier::bits61;
    return formula(CallReader<CallNumbers<61>>(grid));
  }
  if (grid.bits <= 124) {
    tier = Tier::bits124;
    return formula(CallReader<CallNumbers<124>>(grid));
  }
  tier = Tier::big;
  return formula(CallReader<BigCallNumbers>(grid));
}

}  // namespace quoin::detail
