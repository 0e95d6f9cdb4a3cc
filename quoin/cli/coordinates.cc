// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/coordinates.h"

#include <algorithm>

#include "quoin/cli/failure.h"
#include "quoin/cli/numbers.h"

namespace quoin::cli {

namespace {

Rational parse_number(std::string_view word, const std::string& what) {
  try {
    return parse_exact_number(word);
  } catch (const InputError& error) {
    throw InputError(what + ": " + error.what());
  }
}

}  // namespace

std::vector<Rational> parse_coordinates(std::string_view text, std::size_t count, const std::string& what) {
  constexpr std::string_view separators = ", \t\r";
  std::vector<Rational> numbers;
  for (std::size_t at = text.find_first_not_of(separators); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    numbers.push_back(parse_number(text.substr(at, end - at), what));
    at = text.find_first_not_of(separators, end);
  }
  if (numbers.size() != count) {
    throw InputError(what + ": '" + std::string(text) + "' has " + std::to_string(numbers.size()) +
                     " numbers and not " + std::to_string(count));
  }
  return numbers;
}

std::vector<Rational> parse_argument(std::string_view text, std::size_t count, const std::string& what,
                                     std::optional<std::size_t> direction) {
  std::vector<Rational> numbers;
  try {
    numbers = parse_coordinates(text, count, what);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
  const auto is_zero = [](const Rational& number) { return number.sign() == Sign::zero; };
  if (direction && std::all_of(numbers.begin() + static_cast<std::ptrdiff_t>(*direction),
                               numbers.begin() + static_cast<std::ptrdiff_t>(*direction) + 3, is_zero))
    throw UsageError(what + ": '" + std::string(text) + "' has no direction");
  return numbers;
}

}  // namespace quoin::cli
