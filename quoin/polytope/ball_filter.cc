// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/ball_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quoin {

namespace {

constexpr std::size_t block = 1U << 14;  // points between two polls

struct Height {
  double value;
  double bound;  // of its error
};

double taxicab(const Vector3& v) {
  return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z);
}

/// (p - s).((p - c) + (s - c)) where no coordinate exceeds 1. The second factor is at most 4 and off by 2 u for the
/// rounded centers, 4 u for the differences and 4 u for the sum; the first is off by u of its own, products and sums
/// by 3 u: in all below 10 u + 4 (1 + 3) u times the sum of |p - s|.
Height height(const Point3& p, const Point3& s, const Point3& c) {
  const Vector3 d{p.x - s.x, p.y - s.y, p.z - s.z};
  const double value =
      d.x * ((p.x - c.x) + (s.x - c.x)) + d.y * ((p.y - c.y) + (s.y - c.y)) + d.z * ((p.z - c.z) + (s.z - c.z));
  return {value, 0x1p-48 * taxicab(d) + 0x1p-1000};
}

/// The same in pairs. p - s and p + s are exact pairs. p + s - 2 c, at most 4, is off by 2 u^2 for the rounded center
/// and 8 u^2 for two sums of tails below 8 u. Of a product the part that is no error-free product, below 16 u |p - s|,
/// is off by 64 u^2 |p - s|, and what is left out is below 8 u^2 |p - s|. Tails are summed to less than 32 u times the
/// sum of |p - s| by six additions: 192 u^2. In all below 2^9 u^2 times that sum; products below 2^-960 have tails that
/// are off by a few subnormals.
Height height(const Point3& p, const Point3& s, const std::array<TwoDoubles, 3>& c) {
  double sum = 0;
  double tails = 0;
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const TwoDoubles d = two_difference(p[i], s[i]);
    const TwoDoubles both = two_sum(p[i], s[i]);
    const TwoDoubles w = two_difference(both.value, 2 * c[i].value);
    const double w_tail = w.tail + (both.tail - 2 * c[i].tail);
    const TwoDoubles product = two_product(d.value, w.value);
    const TwoDoubles next = two_sum(sum, product.value);
    sum = next.value;
    tails += next.tail + (product.tail + (d.value * w_tail + d.tail * w.value));
    size += std::fabs(d.value);
  }
  return {sum + tails, 0x1p-96 * size + 0x1p-960};
}

/// What the heights of points that are rounded to u err by besides. That of p is (p - c)^2 - (s - c)^2: it changes by
/// (p' - p).(p' + p - 2 c), at most 4 u for each coordinate of p and, likewise, of s: 24 u, with some to spare.
constexpr double rounded_height = 0x1p-48;

/// Of a power of two above the magnitude.
int exponent_above(const Rational& x) {
  if (x.sign() == Sign::zero) return std::numeric_limits<int>::min();
  return static_cast<int>(mpz_sizeinbase(mpq_numref(x.raw()), 2)) -
         static_cast<int>(mpz_sizeinbase(mpq_denref(x.raw()), 2)) + 1;
}

double scaled(double x, int exponent) {
  return std::ldexp(x, exponent);
}

/// In lowest terms, times a power of two.
Rational scaled(const Rational& x, int exponent) {
  Rational result;
  if (exponent >= 0) {
    mpq_mul_2exp(result.raw(), x.raw(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(result.raw(), x.raw(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return result;
}

}  // namespace

BallFilter::BallFilter(std::span<const Point3> points, const Context& context) {
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % block == 0) context.poll();
    const Point3& p = points[i];
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  if (largest > 0) exponent_ = -(std::ilogb(largest) + 1);
  points_.reserve(points.size());
  for (const Point3& p : points) {
    if (points_.size() % block == 0) context.poll();
    points_.push_back({scaled(p.x, exponent_), scaled(p.y, exponent_), scaled(p.z, exponent_)});
  }
}

BallFilter::BallFilter(std::span<const RationalPoint3> points, const Context& context) : are_rounded_(true) {
  constexpr int least = std::numeric_limits<int>::min();
  int above = least;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 256 == 0) context.poll();
    for (unsigned axis = 0; axis < 3; ++axis) above = std::max(above, exponent_above(points[i][axis]));
  }
  if (above != least) exponent_ = -above;
  points_.reserve(points.size());
  for (const RationalPoint3& p : points) {
    if (points_.size() % 256 == 0) context.poll();
    const auto rounded = [&](const Rational& x) { return scaled(x, exponent_).to_double(); };
    points_.push_back({rounded(p.x), rounded(p.y), rounded(p.z)});
  }
}

BallFilter::Sphere BallFilter::sphere_of(const SmallestBall& ball) const {
  Sphere sphere{points_[ball.support[0]], {}};
  for (unsigned axis = 0; axis < 3; ++axis) {
    const Rational center = scaled(ball.center[axis], exponent_);
    sphere.center[axis].value = center.to_double();
    sphere.center[axis].tail = (center - Rational(sphere.center[axis].value)).to_double();
  }
  return sphere;
}

BallFilter::Outcome BallFilter::find_outside(const SmallestBall& ball, const Context& context) const {
  const Sphere sphere = sphere_of(ball);
  Outcome first = in_doubles(sphere, context);
  if (first.outside != nobody || first.open.empty() || are_rounded_) return first;
  return in_pairs(sphere, first.open, context);
}

BallFilter::Outcome BallFilter::in_doubles(const Sphere& sphere, const Context& context) const {
  const Point3 center{sphere.center[0].value, sphere.center[1].value, sphere.center[2].value};
  const double more = are_rounded_ ? rounded_height : 0;
  Outcome outcome;
  double furthest = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (i % block == 0) context.poll();
    const Height h = height(points_[i], sphere.on, center);
    if (h.value > h.bound + more && h.value > furthest) {
      furthest = h.value;
      outcome.outside = static_cast<std::uint32_t>(i);
    }
  }
  if (outcome.outside != nobody) return outcome;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (i % block == 0) context.poll();
    const Height h = height(points_[i], sphere.on, center);
    if (h.value >= -h.bound - more) outcome.open.push_back(static_cast<std::uint32_t>(i));
  }
  return outcome;
}

BallFilter::Outcome BallFilter::in_pairs(const Sphere& sphere, const std::vector<std::uint32_t>& candidates,
                                         const Context& context) const {
  Outcome outcome;
  double furthest = 0;
  std::size_t polled = 0;
  for (const std::uint32_t i : candidates) {
    if (polled++ % block == 0) context.poll();
    const Height h = height(points_[i], sphere.on, sphere.center);
    if (h.value > h.bound && h.value > furthest) {
      furthest = h.value;
      outcome.outside = i;
    }
    if (h.value >= -h.bound) outcome.open.push_back(i);
  }
  return outcome;
}

}  // namespace quoin
