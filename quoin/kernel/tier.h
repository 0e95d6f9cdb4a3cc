// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace quoin {

/// Which tier of a predicate found the sign. Predicates on explicit points have an overload that reports it; the other
/// overload costs nothing for it.
enum class Tier {
  filter,     ///< doubles and a bound of their error
  expansion,  ///< sums of doubles without error, where no product leaves the range in which it is exact
  bits61,     ///< fixed-width integers, coordinates of the call within 61 bits of a common grid
  bits124,    ///< fixed-width integers, coordinates of the call within 124 bits of a common grid
  big         ///< integers or rationals of any size
};

}  // namespace quoin
