// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "quoin/base/sign.h"
#include "quoin/number/rational.h"

namespace quoin {

/// All real numbers between two doubles, both included; an infinite end means "no bound on this side".
///
/// An operation returns an interval that holds every result of the same operation on members. The ends are the
/// nearest doubles outward, found without switching the rounding mode: a sum or product is moved to its neighbour
/// exactly when the tail that rounding cut off says so (error_free.h), or always where the tail is not exact (products
/// below 2^-960 or with factors above 2^995) and in quotients and square roots that are not exact. Hence small
/// integers stay points. Overflow gives an infinite end, underflow an end of one subnormal; no operation makes NaN:
/// zero times an unbounded end is zero, since every member is finite. O(1).
class Interval {
 public:
  /// The point 0.
  Interval() = default;
  /// One finite double.
  Interval(double value) : lower_(value), upper_(value) {}  // NOLINT(google-explicit-constructor)
  /// lower <= upper, neither NaN, lower < infinity, upper > -infinity.
  Interval(double lower, double upper) : lower_(lower), upper_(upper) {}
  /// The whole line.
  static Interval unbounded();
  /// The smallest interval of doubles around a rational: a point exactly if the rational is a double.
  static Interval around(const Rational& value);

  double lower() const { return lower_; }
  double upper() const { return upper_; }
  bool is_point() const { return lower_ == upper_; }
  /// Whether it is of a few units in the last place of its larger end, 2^-47 of that; without an end it is not.
  bool is_narrow() const {
    const double width = upper_ - lower_;
    return std::isfinite(width) && width <= 0x1p-47 * std::max(std::fabs(lower_), std::fabs(upper_));
  }
  bool contains(double value) const { return lower_ <= value && value <= upper_; }
  bool contains(const Rational& value) const;
  bool overlaps(const Interval& other) const { return lower_ <= other.upper_ && other.lower_ <= upper_; }

  /// The sign that all members share, if there is one.
  std::optional<Sign> sign() const {
    if (lower_ > 0) return Sign::positive;
    if (upper_ < 0) return Sign::negative;
    if (lower_ == 0 && upper_ == 0) return Sign::zero;
    return std::nullopt;
  }

  Interval operator-() const { return {-upper_, -lower_}; }
  friend bool operator==(const Interval&, const Interval&) = default;

 private:
  double lower_ = 0;
  double upper_ = 0;
};

Interval operator+(const Interval& a, const Interval& b);
Interval operator-(const Interval& a, const Interval& b);
Interval operator*(const Interval& a, const Interval& b);
/// The whole line where b contains zero.
Interval operator/(const Interval& a, const Interval& b);
/// Of each member, so never below zero: tighter than a * a.
Interval square(const Interval& a);
/// Of the members that are not negative; upper() >= 0.
Interval square_root(const Interval& a);
Interval abs(const Interval& a);

/// Order of all members of a against all of b, if it is the same: zero only for equal points.
std::optional<Sign> compare(const Interval& a, const Interval& b);

}  // namespace quoin
