// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "quoin/arrangement/linear/linear_exact.h"
#include "quoin/arrangement/linear/linear_family.h"

namespace quoin {

/// Lines and points of one predicate call in the numbers N, relative to an origin.
template <class N>
class LinearReader {
 public:
  LinearReader(const LinearFamily& family, const detail::CallGrid& grid, const Point2& origin)
      : family_(family), difference_(grid), origin_(origin) {}

  detail::ExactLine<N> line(BranchId b) const {
    const LinearFamily::Line& l = family_.lines_[b.index()];
    return {difference_(l.ax, origin_.x), difference_(l.ay, origin_.y), difference_(l.bx, l.ax),
            difference_(l.by, l.ay)};
  }
  detail::ExactPoint<N> point(const LinearPoint& p) const {
    if (p.is_crossing()) return detail::exact_crossing<N>(line(BranchId(p.first)), line(BranchId(p.second)));
    return detail::exact_point<N>(difference_(p.x, origin_.x), difference_(p.y, origin_.y));
  }

 private:
  const LinearFamily& family_;
  detail::CallReader<N> difference_;
  Point2 origin_;
};

template <>
class LinearReader<detail::RationalCallNumbers> {
 public:
  explicit LinearReader(const LinearFamily& family) : family_(family) {}

  detail::ExactLine<detail::RationalCallNumbers> line(BranchId b) const {
    const RationalPoint2 a = family_.first_support_point(b);
    const RationalPoint2 c = family_.second_support_point(b);
    return {a.x, a.y, c.x - a.x, c.y - a.y};
  }
  detail::ExactPoint<detail::RationalCallNumbers> point(const LinearPoint& p) const {
    if (p.is_crossing()) {
      return detail::exact_crossing<detail::RationalCallNumbers>(line(BranchId(p.first)), line(BranchId(p.second)));
    }
    if (p.second == LinearPoint::rational_tag) {
      const RationalPoint2& r = family_.rationals_[p.first];
      return {r.x, r.y, Rational(1)};
    }
    if (p.is_end()) {  // of a vertical line: only x means something
      return {family_.first_support_point(BranchId(p.first)).x, Rational(0), Rational(1)};
    }
    return {Rational(p.x), Rational(p.y), Rational(1)};
  }

 private:
  const LinearFamily& family_;
};

namespace detail {

/// The doubles that a predicate call reads.
struct CallValues {
  std::array<double, 16> values{};
  std::size_t count = 0;
  void add(const Point2& p) {
    values[count++] = p.x;
    values[count++] = p.y;
  }
  CallGrid grid() const { return CallGrid(std::span<const double>(values.data(), count)); }
};

/// Calls the formula with a reader in the narrowest numbers that hold the coordinates of the call.
template <class Formula>
auto on_grid(const LinearFamily& family, const CallValues& values, const Formula& formula) {
  const CallGrid grid = values.grid();
  const Point2 origin{values.values[0], values.values[1]};
  if (grid.bits <= 22) return formula(LinearReader<CallNumbers<22>>(family, grid, origin), grid);
  if (grid.bits <= 61) return formula(LinearReader<CallNumbers<61>>(family, grid, origin), grid);
  if (grid.bits <= 124) return formula(LinearReader<CallNumbers<124>>(family, grid, origin), grid);
  return formula(LinearReader<BigCallNumbers>(family, grid, origin), grid);
}

}  // namespace detail

}  // namespace quoin
