// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/kernel/rational_point.h"

namespace quoin::planar {

/// Two rational unit vectors close to the direction of a vector: one clockwise of it, one counterclockwise, or both the
/// same if its length is rational.
struct UnitBracket {
  RationalPoint2 clockwise;
  RationalPoint2 counterclockwise;
  bool is_exact = false;
};

/// Both have at least `cosine` times their length along the vector, which must not be zero; 0 < cosine < 1.
///
/// Points of the unit circle at ((1 - t^2) / (1 + t^2), 2 t / (1 + t^2)) for neighbouring multiples t of a power of
/// two, about log2(1 / (1 - cosine)) / 2 bits long; certified by exact arithmetic.
UnitBracket unit_bracket(const RationalPoint2& vector, const Rational& cosine);

}  // namespace quoin::planar
