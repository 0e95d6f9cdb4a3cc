// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "quoin/number/rational.h"

/// Words of the exact text forms: names and numbers that read back without loss.
namespace quoin::io {

/// Any text as one word: spaces, '#', '%' and control characters become %XX.
std::string encoded_name(std::string_view name);
std::string decoded_name(std::string_view word);

/// A finite double as the shortest decimal that is nearest to it: an integer below 2^53 in digits alone, all others
/// with a point or an exponent.
std::string exact_word(double value);
/// As a double where it is one, else as an integer or p/q.
std::string exact_word(const Rational& value);

/// A number that is a double, or else a rational.
struct ExactNumber {
  std::optional<double> value;  ///< if it is a double
  Rational exact;               ///< only if it is not

  Rational rational() const { return value ? Rational(*value) : exact; }
};

/// Digits alone and p/q are exact; a word with a point or an exponent is the nearest double. @throws InputError
ExactNumber parse_exact(std::string_view word);

}  // namespace quoin::io
