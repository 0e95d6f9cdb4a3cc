// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/number/integer.h"

namespace quoin {

/// A dense matrix of integers, by rows of equal length.
using IntegerMatrix = std::vector<std::vector<Integer>>;

/// The elementary divisors of a matrix: d1 | d2 | ... | dr, all positive, r its rank. Exact, for integers of any size.
///
/// The rank r and a minor of order r come from elimination without fractions; the minor is a multiple of dr, so that
/// the rest is done modulo it and numbers do not grow. O(r n m) steps on integers of O(r log(r a)) bits for entries
/// below a. @throws Cancelled
/// Source: Bareiss (1968); Domich, Kannan, Trotter: Hermite normal form modulo the determinant (1987).
std::vector<Integer> elementary_divisors(IntegerMatrix matrix, const Context& context);

/// The greatest common divisor, not negative.
Integer greatest_common_divisor(const Integer& a, const Integer& b);

}  // namespace quoin
