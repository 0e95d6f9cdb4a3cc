// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/numbers.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "quoin/base/error.h"
#include "quoin/io/text_lines.h"

namespace quoin::cli {

namespace {

/// Takes digits off the front of the rest of a word.
std::string_view take_digits(std::string_view& rest) {
  const std::size_t end = std::min(rest.find_first_not_of("0123456789"), rest.size());
  const std::string_view digits = rest.substr(0, end);
  rest.remove_prefix(end);
  return digits;
}

bool take(std::string_view& rest, std::string_view any_of) {
  if (rest.empty() || any_of.find(rest.front()) == std::string_view::npos) return false;
  rest.remove_prefix(1);
  return true;
}

/// (-1)^is_negative * digits * 10^exponent.
class Decimal {
 public:
  explicit Decimal(std::string_view word) : word_(word) {
    std::string_view rest = word;
    is_negative_ = rest.starts_with('-');
    take(rest, "+-");
    digits_ = take_digits(rest);
    if (take(rest, ".")) {
      const std::string_view fraction = take_digits(rest);
      exponent_ = -static_cast<long>(fraction.size());
      digits_ += fraction;
    }
    if (digits_.empty()) fail();
    if (take(rest, "eE")) exponent_ += exponent_of(rest);
    if (!rest.empty()) fail();
  }

  bool is_zero() const { return digits_.find_first_not_of('0') == std::string::npos; }

  /// Infinite where it is beyond all doubles.
  double nearest() const {
    const std::string_view unsigned_word = word_.substr(word_.find_first_not_of("+-"));
    double value = 0;
    const auto [end, error] = std::from_chars(unsigned_word.data(), unsigned_word.data() + unsigned_word.size(), value);
    if (error == std::errc::result_out_of_range) value = is_large() ? std::numeric_limits<double>::infinity() : 0;
    return is_negative_ ? -value : value;
  }

  Rational exact() const {
    const std::string zeros(static_cast<std::size_t>(std::labs(exponent_)), '0');
    const Integer digits = Integer::parse((is_negative_ ? "-" : "") + digits_ + (exponent_ > 0 ? zeros : ""));
    return exponent_ < 0 ? Rational(digits, Integer::parse("1" + zeros)) : Rational(digits);
  }

 private:
  long exponent_of(std::string_view& rest) const {
    const bool is_negative = rest.starts_with('-');
    take(rest, "+-");
    std::string_view digits = take_digits(rest);
    if (digits.empty()) fail();
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size() - 1));
    unsigned size = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), size);
    if (error != std::errc() || size > largest_exponent) {
      throw InputError(io::quoted(word_) + " has an exponent beyond " + std::to_string(largest_exponent));
    }
    return is_negative ? -static_cast<long>(size) : static_cast<long>(size);
  }
  /// At least 1; tells large ones from small ones where neither has a double.
  bool is_large() const {
    const std::size_t first = digits_.find_first_not_of('0');
    return first != std::string::npos && static_cast<long>(digits_.size() - first) + exponent_ > 0;
  }
  [[noreturn]] void fail() const { throw InputError(io::quoted(word_) + " is not a finite number"); }

  std::string_view word_;
  std::string digits_;
  long exponent_ = 0;
  bool is_negative_ = false;
};

}  // namespace

Rational parse_exact_number(std::string_view word) {
  if (word.find('/') != std::string_view::npos) return Rational::parse(word);
  const Decimal decimal(word);
  const double nearest = decimal.nearest();
  const bool has_double = std::isfinite(nearest) && (nearest != 0 || decimal.is_zero());
  return has_double ? Rational(nearest) : decimal.exact();
}

double parse_double(std::string_view word) {
  const double nearest = Decimal(word).nearest();
  if (!std::isfinite(nearest)) throw InputError(io::quoted(word) + " is beyond the largest double");
  return nearest;
}

}  // namespace quoin::cli
