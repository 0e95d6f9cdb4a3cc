// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "quoin/arrangement/circular/circular_kernel.h"
#include "quoin/arrangement/circular/circular_support.h"
#include "quoin/number/error_free.h"
#include "quoin/number/integer.h"

/// Operands of one call of the exact tier as integers over a common denominator.
namespace quoin::circular_exact {

/// Exponent of the lowest set bit of a number that is finite and not zero.
inline int lowest_bit(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int exponent = static_cast<int>((bits >> 52) & 0x7FF);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  if (exponent == 0) return -1074 + std::countr_zero(fraction);
  return exponent - 1075 + std::countr_zero(fraction | (std::uint64_t{1} << 52));
}

/// The grid of a call: a power of two of which all coordinates relative to the first point are multiples.
class Grid {
 public:
  explicit Grid(const CircularPools& pools) : pools_(pools) {}

  void add_support(std::uint32_t id) {
    const CircularSupport& s = pools_.supports[id];
    supports_[support_count_++] = id;
    if (s.is_rational()) {
      rational_ = true;
      return;
    }
    add_coordinates(s.x, s.y);
    if (s.form == CircularForm::segment) {
      add_coordinates(s.end_x, s.end_y);
    } else if (s.form == CircularForm::radius) {
      low_ = std::min(low_, lowest_bit(s.radius));
      reach_ = std::max(reach_, s.radius);
    } else {
      const int low = lowest_bit(s.squared_radius);
      low_ = std::min(low_, low >= 0 ? low / 2 : -((1 - low) / 2));
      reach_ = std::max(reach_, 1.0001 * s.radius);
    }
  }
  void add_point(const CircularPoint& p) {
    if (p.kind == CircularPointKind::rational) rationals_[rational_count_++] = p.rational;
    switch (p.kind) {
      case CircularPointKind::doubles:
        return add_coordinates(p.x, p.y);
      case CircularPointKind::rational:
        rational_ = true;
        return;
      case CircularPointKind::crossing:
        add_support(p.first);
        return add_support(p.second);
      case CircularPointKind::extreme:
        return add_support(p.first);
    }
  }

  /// All numbers of the call are integers below 2^bits on the grid. The reach is rounded, which moves it across a power
  /// of two only upward.
  bool fits(int bits) const {
    return !rational_ && (reach_ == 0 || low_ == unset || std::ilogb(reach_) + 1 - low_ <= bits);
  }

  double origin_x() const { return origin_x_; }
  double origin_y() const { return origin_y_; }
  int low() const { return low_ == unset ? 0 : low_; }
  const CircularPools& pools() const { return pools_; }

  /// A common multiple of all denominators.
  Integer denominator() const {
    Integer result(1);
    const auto add = [&](const Integer& w) { mpz_lcm(result.raw(), result.raw(), w.raw()); };
    for (std::size_t i = 0; i < support_count_; ++i) {
      const CircularSupport& s = pools_.supports[supports_[i]];
      if (s.form == CircularForm::rational_circle) add(pools_.circles[s.rational].w);
      if (s.form == CircularForm::rational_line) add(pools_.lines[s.rational].w);
    }
    for (std::size_t i = 0; i < rational_count_; ++i) add(pools_.points[rationals_[i]].w);
    const std::size_t present = result.trailing_zeros();
    if (low() < 0 && present < static_cast<std::size_t>(-low())) result <<= static_cast<std::size_t>(-low()) - present;
    return result;
  }

 private:
  static constexpr int unset = std::numeric_limits<int>::max();

  void add_coordinates(double x, double y) {
    if (!has_origin_) {
      origin_x_ = x;
      origin_y_ = y;
      has_origin_ = true;
    }
    if (x != 0) low_ = std::min(low_, lowest_bit(x));
    if (y != 0) low_ = std::min(low_, lowest_bit(y));
    reach_ = std::max({reach_, std::fabs(x - origin_x_), std::fabs(y - origin_y_)});
  }

  const CircularPools& pools_;
  std::array<std::uint32_t, 6> supports_{};   // two crossings and two more
  std::array<std::uint32_t, 2> rationals_{};  // points
  std::size_t support_count_ = 0;
  std::size_t rational_count_ = 0;
  double origin_x_ = 0;
  double origin_y_ = 0;
  double reach_ = 0;
  int low_ = unset;
  bool has_origin_ = false;
  bool rational_ = false;
};

/// Reads operands as integers on the grid of the call.
template <std::size_t B>
class GridReader {
 public:
  using Numbers = IntegersOf<B>;
  explicit GridReader(const Grid& grid) : grid_(grid), scale_(std::ldexp(1.0, -grid.low())) {}

  typename Numbers::Coordinate x(double value) const { return coordinate(value, grid_.origin_x()); }
  typename Numbers::Coordinate y(double value) const { return coordinate(value, grid_.origin_y()); }

  ExactCircle<Numbers> circle(std::uint32_t id) const {
    const CircularSupport& s = grid_.pools().supports[id];
    return {x(s.x), y(s.y), squared_radius(s)};
  }
  ExactLine<Numbers> line(std::uint32_t id) const {
    const CircularSupport& s = grid_.pools().supports[id];
    return {x(s.x), y(s.y), x(s.end_x), y(s.end_y)};
  }
  ExactPoint<Numbers> explicit_point(const CircularPoint& p) const {
    using Factor = typename Numbers::Factor;
    return {x(p.x), y(p.y), Factor(0), Factor(0), typename Numbers::Radicand(0), typename Numbers::Denominator(1)};
  }
  const Grid& grid() const { return grid_; }
  double unit() const { return 1 / scale_; }

 private:
  typename Numbers::Coordinate coordinate(double value, double origin) const {
    // Both parts of the difference are multiples of the grid.
    const TwoDoubles difference = two_difference(value, origin);
    return typename Numbers::Coordinate(static_cast<std::int64_t>(difference.value * scale_) +
                                        static_cast<std::int64_t>(difference.tail * scale_));
  }
  typename Numbers::SquaredRadius squared_radius(const CircularSupport& s) const {
    if (s.form == CircularForm::radius) {
      const typename Numbers::Coordinate radius(static_cast<std::int64_t>(s.radius * scale_));
      return radius * radius;
    }
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(s.squared_radius, &exponent), 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    const int shift = exponent - 53 - 2 * grid_.low() + zeros;  // not negative: the grid was chosen so
    using Limbs = typename Numbers::SquaredRadius::Limbs;
    return typename Numbers::SquaredRadius(shift_left(Limbs(mantissa >> zeros), static_cast<std::size_t>(shift)));
  }

  const Grid& grid_;
  double scale_;
};

/// Reads operands as integers over their common denominator.
class BigReader {
 public:
  using Numbers = Integers;
  explicit BigReader(const Grid& grid) : grid_(grid), w_(grid.denominator()) {}

  ExactCircle<Integers> circle(std::uint32_t id) const {
    const CircularSupport& s = grid_.pools().supports[id];
    if (s.form == CircularForm::rational_circle) {
      const HomogeneousCircle& c = grid_.pools().circles[s.rational];
      const Integer factor = factor_of(c.w);
      return {c.x * factor, c.y * factor, c.square * factor * factor};
    }
    if (s.form == CircularForm::squared_radius) {
      return {scaled(s.x, w_), scaled(s.y, w_), scaled(s.squared_radius, w_ * w_)};
    }
    const Integer radius = scaled(s.radius, w_);
    return {scaled(s.x, w_), scaled(s.y, w_), radius * radius};
  }
  ExactLine<Integers> line(std::uint32_t id) const {
    const CircularSupport& s = grid_.pools().supports[id];
    if (s.form == CircularForm::rational_line) {
      const HomogeneousLine& l = grid_.pools().lines[s.rational];
      const Integer factor = factor_of(l.w);
      return {l.x * factor, l.y * factor, l.end_x * factor, l.end_y * factor};
    }
    return {scaled(s.x, w_), scaled(s.y, w_), scaled(s.end_x, w_), scaled(s.end_y, w_)};
  }
  ExactPoint<Integers> explicit_point(const CircularPoint& p) const {
    if (p.kind == CircularPointKind::doubles) {
      return {scaled(p.x, w_), scaled(p.y, w_), 0, 0, 0, 1};
    }
    const HomogeneousPoint& q = grid_.pools().points[p.rational];
    const Integer factor = factor_of(q.w);
    return {q.x * factor, q.y * factor, 0, 0, 0, 1};
  }
  const Grid& grid() const { return grid_; }
  const Integer& denominator() const { return w_; }

 private:
  Integer factor_of(const Integer& w) const {
    Integer result;
    mpz_divexact(result.raw(), w_.raw(), w.raw());
    return result;
  }
  /// value times w, an integer.
  static Integer scaled(double value, Integer w) {
    if (value == 0) return {};
    const int low = lowest_bit(value);
    w *= Integer(static_cast<std::int64_t>(std::ldexp(value, -low)));
    if (low >= 0) return w << static_cast<std::size_t>(low);
    return w >> static_cast<std::size_t>(-low);
  }

  const Grid& grid_;
  Integer w_;
};

}  // namespace quoin::circular_exact
