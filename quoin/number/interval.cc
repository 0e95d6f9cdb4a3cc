// SPDX-License-Identifier: Apache-2.0
//
// Ends are rounded outward from the result rounded to nearest, r, of an exact result x. Where r is finite, x lies
// between its neighbours; where r is +infinity, x >= the largest double, r's lower neighbour; where r is zero, x lies
// between the two smallest subnormals. So stepping to a neighbour is always enough, and stepping only if the tail
// x - r points outward is exact.
#include "quoin/number/interval.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quoin/number/error_free.h"

namespace quoin {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double step_down(double x) {
  return std::nextafter(x, -infinity);
}
double step_up(double x) {
  return std::nextafter(x, infinity);
}

// Neither is called with infinities of both signs: lower ends are never +infinity, upper ends never -infinity.
double sum_down(double a, double b) {
  const TwoDoubles sum = two_sum(a, b);
  if (std::isinf(sum.value)) return std::isinf(a) || std::isinf(b) ? sum.value : step_down(sum.value);
  // The tail is no number where b is the largest double and a part of the transformation overflows.
  return sum.tail >= 0 && sum.tail < infinity ? sum.value : step_down(sum.value);
}
double sum_up(double a, double b) {
  return -sum_down(-a, -b);
}

// An infinite factor is a bound that is not there; times zero it is zero.
double product_down(double a, double b) {
  if (a == 0 || b == 0) return 0;
  const double product = a * b;
  if (std::isinf(a) || std::isinf(b)) return product;
  if (!is_product_exact_range(a, b)) return step_down(product);
  return two_product(a, b).tail < 0 ? step_down(product) : product;
}
double product_up(double a, double b) {
  return -product_down(-a, b);
}

// b != 0. The remainder a - q b is exact where the product q b is and q is normal, and its sign is that of the tail
// times b.
double quotient_down(double a, double b) {
  if (a == 0 || std::isinf(b)) return 0;  // the limit for growing b, also of growing a among others
  const double q = a / b;
  if (std::isinf(a)) return q;
  if (std::fabs(q) < std::numeric_limits<double>::min() || !is_product_exact_range(q, b)) return step_down(q);
  const TwoDoubles product = two_product(q, b);
  const double rest = (a - product.value) - product.tail;
  return (rest < 0) != (b < 0) && rest != 0 ? step_down(q) : q;
}
double quotient_up(double a, double b) {
  return -quotient_down(-a, b);
}

}  // namespace

Interval Interval::unbounded() {
  return {-infinity, infinity};
}

Interval Interval::around(const Rational& value) {
  const double nearest = value.to_double();
  if (nearest == infinity) return {std::numeric_limits<double>::max(), infinity};
  if (nearest == -infinity) return {-infinity, std::numeric_limits<double>::lowest()};
  const Rational exact(nearest);
  return {exact <= value ? nearest : step_down(nearest), exact >= value ? nearest : step_up(nearest)};
}

bool Interval::contains(const Rational& value) const {
  return (lower_ == -infinity || Rational(lower_) <= value) && (upper_ == infinity || value <= Rational(upper_));
}

Interval operator+(const Interval& a, const Interval& b) {
  return {sum_down(a.lower(), b.lower()), sum_up(a.upper(), b.upper())};
}

Interval operator-(const Interval& a, const Interval& b) {
  return a + (-b);
}

Interval operator*(const Interval& a, const Interval& b) {
  const double al = a.lower();
  const double au = a.upper();
  const double bl = b.lower();
  const double bu = b.upper();
  return {std::min(std::min(product_down(al, bl), product_down(al, bu)),
                   std::min(product_down(au, bl), product_down(au, bu))),
          std::max(std::max(product_up(al, bl), product_up(al, bu)), std::max(product_up(au, bl), product_up(au, bu)))};
}

Interval operator/(const Interval& a, const Interval& b) {
  if (b.lower() <= 0 && b.upper() >= 0) return Interval::unbounded();
  const double al = a.lower();
  const double au = a.upper();
  const double bl = b.lower();
  const double bu = b.upper();
  return {
      std::min(std::min(quotient_down(al, bl), quotient_down(al, bu)),
               std::min(quotient_down(au, bl), quotient_down(au, bu))),
      std::max(std::max(quotient_up(al, bl), quotient_up(al, bu)), std::max(quotient_up(au, bl), quotient_up(au, bu)))};
}

Interval square(const Interval& a) {
  const Interval size = abs(a);
  return {product_down(size.lower(), size.lower()), product_up(size.upper(), size.upper())};
}

// IEEE square roots are rounded to nearest; one is exact only if its square is the argument.
Interval square_root(const Interval& a) {
  const auto is_exact = [](double x, double root) {
    if (!is_product_exact_range(root, root)) return x == 0;
    const TwoDoubles power = two_product(root, root);
    return power.value == x && power.tail == 0;
  };
  const double low = std::max(a.lower(), 0.0);
  const double low_root = std::sqrt(low);
  const double high_root = std::sqrt(a.upper());
  return {is_exact(low, low_root) ? low_root : step_down(low_root),
          std::isinf(high_root) || is_exact(a.upper(), high_root) ? high_root : step_up(high_root)};
}

Interval abs(const Interval& a) {
  if (a.lower() >= 0) return a;
  if (a.upper() <= 0) return -a;
  return {0, std::max(-a.lower(), a.upper())};
}

std::optional<Sign> compare(const Interval& a, const Interval& b) {
  if (a.upper() < b.lower()) return Sign::negative;
  if (a.lower() > b.upper()) return Sign::positive;
  if (a.is_point() && a == b) return Sign::zero;
  return std::nullopt;
}

}  // namespace quoin
