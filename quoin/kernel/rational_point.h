// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/number/rational.h"

namespace quoin {

/// A point of space with exact rational coordinates.
struct RationalPoint3 {
  Rational x;
  Rational y;
  Rational z;
  friend bool operator==(const RationalPoint3&, const RationalPoint3&) = default;
};

}  // namespace quoin
