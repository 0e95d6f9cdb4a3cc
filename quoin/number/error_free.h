// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

/// Error-free transformations: a rounded result together with the part that rounding cut off.
///
/// No fused operation and no rounding mode is used; the target is compiled with -ffp-contract=off, on which every line
/// here rests. Sources: Dekker 1971, Knuth (The Art of Computer Programming 2, 4.2.2), Shewchuk 1997.
namespace quoin {

/// The unevaluated sum `value + tail`, where `value` is the sum rounded to nearest.
struct TwoDoubles {
  double value = 0;
  double tail = 0;
};

/// a + b. Exact for all finite a and b, |b| below the largest double, whose rounded sum is finite (Boldo, Graillat,
/// Muller 2017); sums never underflow. 6 operations.
inline TwoDoubles two_sum(double a, double b) {
  const double sum = a + b;
  const double b_virtual = sum - a;
  const double a_virtual = sum - b_virtual;
  return {sum, (a - a_virtual) + (b - b_virtual)};
}

/// a + b where |a| >= |b| or a = 0. Exact as two_sum. 3 operations.
inline TwoDoubles fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a - b. Exact as two_sum.
inline TwoDoubles two_difference(double a, double b) {
  const double difference = a - b;
  const double b_virtual = a - difference;
  const double a_virtual = difference + b_virtual;
  return {difference, (a - a_virtual) + (b_virtual - b)};
}

/// x as the sum of two numbers of at most 26 bits each (sign included in the low one). Exact for |x| <= 2^995; beyond,
/// the multiplication may overflow. Subnormals are split exactly too.
inline TwoDoubles split(double x) {
  const double c = 0x1.0000002p27 * x;  // 2^27 + 1
  const double high = c - (c - x);
  return {high, x - high};
}

/// a b. Exact where `is_product_exact_range` says so: the tail is a multiple of the product of the lowest bits of a and
/// b, which must be at least 2^-1074, and neither split may overflow. Elsewhere the tail is meaningless, the value not.
inline TwoDoubles two_product(double a, double b) {
  const double product = a * b;
  const TwoDoubles x = split(a);
  const TwoDoubles y = split(b);
  const double high = product - x.value * y.value;
  return {product, x.tail * y.tail - ((high - x.tail * y.value) - x.value * y.tail)};
}

/// Sufficient for two_product(a, b) to be exact: |a|, |b| <= 2^995, and a b is zero by a factor or 2^-960 <= |a b| <
/// 2^1020.
///
/// With a, b integers below 2^53 times 2^i, 2^j, |a b| < 2^(106 + i + j), so |a b| >= 2^-960 gives i + j > -1066, and
/// every partial product, a multiple of 2^(i + j), is free of underflow.
inline bool is_product_exact_range(double a, double b) {
  const double size = std::fabs(a * b);
  return std::fabs(a) <= 0x1p995 && std::fabs(b) <= 0x1p995 &&
         ((size >= 0x1p-960 && size < 0x1p1020) || a == 0 || b == 0);
}

}  // namespace quoin
