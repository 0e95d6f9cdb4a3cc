// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "quoin/arrangement/circular/circular_family.h"
#include "quoin/kernel/box.h"
#include "quoin/kernel/point.h"

/// Rounded shapes of pieces of a CircularFamily, with what is certain of them, and exact coordinates of points.
namespace quoin {

/// Contains the piece of the branch between two of its points.
Box2 box(const CircularFamily& family, BranchId branch, const CircularPoint& left, const CircularPoint& right);

/// A point of the piece half-way along it, rounded.
Point2 arc_midpoint(const CircularFamily& family, BranchId branch, const CircularPoint& left,
                    const CircularPoint& right);

/// The piece as a chain from left to right, both ends included, no further from it than `tolerance` plus rounding. At
/// most 2^16 edges.
std::vector<Point2> flatten(const CircularFamily& family, BranchId branch, const CircularPoint& left,
                            const CircularPoint& right, double tolerance);

/// A number within `error` of the true one.
struct CertifiedDouble {
  double value = 0;
  double error = 0;
};

/// The integral of y dx along the piece from left to right: the areas of faces are sums of such.
CertifiedDouble area_under(const CircularFamily& family, BranchId branch, const CircularPoint& left,
                           const CircularPoint& right);

/// a x + b y = c, where (b, -a) runs in lexicographic order.
struct LineCoefficients {
  Rational a;
  Rational b;
  Rational c;
};
LineCoefficients coefficients(const CircularFamily& family, CircularSupportId line);

/// Exact coordinates (ax + bx sqrt c, ay + by sqrt c), c >= 0.
struct OneRootPoint {
  Rational ax;
  Rational bx;
  Rational ay;
  Rational by;
  Rational c;
};
OneRootPoint exact_coordinates(const CircularFamily& family, const CircularPoint& p);

/// low <= value <= high
struct RationalBounds {
  Rational low;
  Rational high;
};
/// Of a + b sqrt c; high - low <= |b| 2^-bits, and equal if sqrt c is a multiple of 2^-bits.
RationalBounds bounds_of(const Rational& a, const Rational& b, const Rational& c, std::size_t bits);

}  // namespace quoin
