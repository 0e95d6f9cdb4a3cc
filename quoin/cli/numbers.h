// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "quoin/number/rational.h"

namespace quoin::cli {

/// The largest size of an exponent in `parse_exact_number`.
inline constexpr unsigned largest_exponent = 99'999;

/// One number: a decimal, or a fraction p/q, exact. A decimal stands for the nearest double, as in files; where that is
/// infinite, or zero though the decimal is not, for itself. Larger decimals so stand for no smaller numbers.
/// @throws InputError  that quotes the word: it is neither, as 'nan', '1e' and '0x10' are, or has blanks, or its
/// exponent
///                     is beyond `largest_exponent`
Rational parse_exact_number(std::string_view word);

/// The nearest double of one decimal. @throws InputError  that quotes the word: it is no decimal, or beyond the largest
/// double
double parse_double(std::string_view word);

}  // namespace quoin::cli
