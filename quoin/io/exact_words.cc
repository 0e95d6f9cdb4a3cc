// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/exact_words.h"

#include <array>
#include <charconv>
#include <cmath>

#include "quoin/base/error.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

std::string encoded_name(std::string_view name) {
  static constexpr char digits[] = "0123456789ABCDEF";
  std::string word;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 0x20 && byte != 0x7F && c != '#' && c != '%') {
      word += c;
    } else {
      word += {'%', digits[byte >> 4], digits[byte & 15]};
    }
  }
  return word;
}

std::string decoded_name(std::string_view word) {
  std::string name;
  for (std::size_t i = 0; i < word.size(); ++i) {
    unsigned byte = 0;
    if (word[i] == '%' && i + 2 < word.size()) {
      const auto [end, error] = std::from_chars(word.data() + i + 1, word.data() + i + 3, byte, 16);
      if (error == std::errc() && end == word.data() + i + 3) {
        name += static_cast<char>(byte);
        i += 2;
        continue;
      }
    }
    name += word[i];
  }
  return name;
}

std::string exact_word(double value) {
  if (value == 0) return "0";  // minus zero too
  std::array<char, 64> text{};
  char* const begin = text.data();
  char* end = std::to_chars(begin, begin + text.size(), value).ptr;
  const bool is_whole =
      std::string_view(begin, static_cast<std::size_t>(end - begin)).find_first_of(".e") == std::string_view::npos;
  // Digits alone would be read as all the digits of an integer.
  if (is_whole && std::fabs(value) >= 0x1p53) {
    end = std::to_chars(begin, begin + text.size(), value, std::chars_format::scientific).ptr;
  }
  return {begin, end};
}

std::string exact_word(const Rational& value) {
  const double rounded = value.to_double();
  const bool is_double = std::isfinite(rounded) && Rational(rounded) == value;
  return is_double ? exact_word(rounded) : value.to_string();
}

ExactNumber parse_exact(std::string_view word) {
  ExactNumber number;
  const bool is_decimal = word.find_first_of(".eE") != std::string_view::npos;
  if (is_decimal || (word.size() < 16 && word.find('/') == std::string_view::npos)) {
    double value = 0;
    if (!parse_number(word, value)) throw InputError(quoted(word) + " is not a finite number");
    number.value = value == 0 ? 0 : value;
    return number;
  }
  number.exact = Rational::parse(word);
  const double rounded = number.exact.to_double();
  if (std::isfinite(rounded) && Rational(rounded) == number.exact) number.value = rounded;
  return number;
}

}  // namespace quoin::io
