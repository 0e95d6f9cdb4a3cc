// SPDX-License-Identifier: Apache-2.0
#include "quoin/number/integer.h"

#include <cctype>
#include <memory>

#include "quoin/base/error.h"

namespace quoin {

namespace {

bool is_decimal(std::string_view text) {
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  if (text.empty()) return false;
  for (const char c : text) {
    if (c < '0' || c > '9') return false;
  }
  return true;
}

}  // namespace

Integer Integer::parse(std::string_view text) {
  if (!is_decimal(text)) throw InputError("not an integer: '" + std::string(text.substr(0, 60)) + "'");
  if (text.front() == '+') text.remove_prefix(1);
  Integer result;
  mpz_set_str(result.value_, std::string(text).c_str(), 10);
  return result;
}

std::string Integer::to_string() const {
  std::string digits(mpz_sizeinbase(value_, 10) + 2, '\0');
  mpz_get_str(digits.data(), 10, value_);
  digits.resize(digits.find('\0'));
  return digits;
}

}  // namespace quoin
