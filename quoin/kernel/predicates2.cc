// SPDX-License-Identifier: Apache-2.0
//
// Filter of orientation: with u = 2^-53, the computed differences carry a relative error u, each product then (1+u)^3 -
// 1 in all, and the final difference another u, so |error| <= (4 u + O(u^2)) (|left| + |right|) for the computed
// products; 4.5e-16 > 4 u (1 + 4 u). The bound holds while neither product underflows: it is used only for products of
// at least 2^-900 or of exactly zero factors.
#include "quoin/kernel/predicates2.h"

#include <cmath>

#include "quoin/number/rational.h"

namespace quoin {

namespace {

constexpr double relative_bound = 4.5e-16;
constexpr double smallest_safe = 0x1p-900;
constexpr double largest_safe = 0x1p900;

Sign exact_orientation(const Point2& a, const Point2& b, const Point2& c) {
  const Rational ax(a.x);
  const Rational ay(a.y);
  return ((Rational(b.x) - ax) * (Rational(c.y) - ay) - (Rational(b.y) - ay) * (Rational(c.x) - ax)).sign();
}

// Whether x - y was computed without error: the classical two-difference leaves no tail.
bool is_exact_difference(double x, double y, double difference) {
  const double virtual_y = x - difference;
  const double virtual_x = difference + virtual_y;
  return (virtual_y - y) + (x - virtual_x) == 0;
}

// The part of x y that rounding cut off, by splitting both into halves of 26 bits (Dekker 1971); no fused operation.
double product_tail(double x, double y, double product) {
  constexpr double splitter = 0x1p27 + 1;
  const double cx = splitter * x;
  const double x_high = cx - (cx - x);
  const double x_low = x - x_high;
  const double cy = splitter * y;
  const double y_high = cy - (cy - y);
  const double y_low = y - y_high;
  return x_low * y_low - (((product - x_high * y_high) - x_low * y_high) - x_high * y_low);
}

bool is_safe(double product) {
  const double size = std::fabs(product);
  return size >= smallest_safe && size <= largest_safe;
}

}  // namespace

Sign orientation(const Point2& a, const Point2& b, const Point2& c) {
  const double bx = b.x - a.x;
  const double by = b.y - a.y;
  const double cx = c.x - a.x;
  const double cy = c.y - a.y;
  const double left = bx * cy;
  const double right = by * cx;
  const double area = left - right;
  const double bound = relative_bound * (std::fabs(left) + std::fabs(right));
  if (is_safe(left) && is_safe(right)) {
    if (area > bound || area < -bound) return sign_of(area);
    if (is_exact_difference(b.x, a.x, bx) && is_exact_difference(b.y, a.y, by) && is_exact_difference(c.x, a.x, cx) &&
        is_exact_difference(c.y, a.y, cy)) {
      // Rounding is monotone: different rounded products order the exact ones.
      if (left != right) return sign_of(area);
      const double left_tail = product_tail(bx, cy, left);
      const double right_tail = product_tail(by, cx, right);
      return static_cast<Sign>((left_tail > right_tail) - (left_tail < right_tail));
    }
  }
  return exact_orientation(a, b, c);
}

}  // namespace quoin
