// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/text_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace quoin::io {

std::string_view first_word(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  return text.substr(begin, text.find_first_of(" \t\r\n", begin) - begin);
}

std::string_view first_word(std::string_view text, char comment) {
  std::string_view word = first_word(text);
  while (word.starts_with(comment)) {
    text.remove_prefix(static_cast<std::size_t>(word.data() - text.data()));
    text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
    word = first_word(text);
  }
  return word;
}

std::string quoted(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, 40)) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte < 0x20 || byte == 0x7F ? '?' : c;
  }
  return text + "'";
}

bool is_word(std::string_view word, std::string_view lower_case) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(word, lower_case, {}, lower);
}

namespace {

// Whether a number that is no double, too small or too large, is the former: by the power of ten of its first digit.
bool is_too_small(std::string_view word) {
  const std::size_t e = std::min(word.find_first_of("eE"), word.size());
  const std::size_t point = std::min(word.find('.'), e);
  const std::size_t first = std::min(word.find_first_of("123456789"), e);
  const auto power = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  std::string_view exponent = word.substr(std::min(e + 1, word.size()));
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  std::int64_t value = 0;
  const auto error = std::from_chars(exponent.data(), exponent.data() + exponent.size(), value).ec;
  if (error == std::errc::result_out_of_range) return exponent.starts_with('-');
  constexpr std::int64_t far = std::int64_t{1} << 60;
  return power + std::clamp(value, -far, far) < 0;
}

}  // namespace

bool parse_number(std::string_view word, double& value) {
  return parse_any_number(word, value) && std::isfinite(value);
}

bool parse_any_number(std::string_view word, double& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return false;
  if (error == std::errc::result_out_of_range) {  // too small is nearest to zero, too large is no double
    constexpr double infinity = std::numeric_limits<double>::infinity();
    value = is_too_small(word) ? 0 : word.starts_with('-') ? -infinity : infinity;
    return true;
  }
  return error == std::errc();
}

std::string_view TextLines::take_line() {
  ++line_;
  const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
  const std::string_view line = text_.substr(position_, end - position_);
  position_ = end;
  if (position_ < text_.size()) {
    const bool pair = text_[position_] == '\r' && position_ + 1 < text_.size() && text_[position_ + 1] == '\n';
    position_ += pair ? 2 : 1;
  }
  return line;
}

void TextLines::split(std::string_view line) {
  line = line.substr(0, line.find(comment_));
  std::size_t i = 0;
  while (true) {
    i = line.find_first_not_of(" \t\v\f", i);
    if (i == std::string_view::npos) return;
    const std::size_t end = std::min(line.find_first_of(" \t\v\f", i), line.size());
    words_.push_back(line.substr(i, end - i));
    i = end;
  }
}

bool TextLines::next() {
  words_.clear();
  while (words_.empty()) {
    if (position_ >= text_.size()) return false;
    split(take_line());
    while (joins_ && !words_.empty() && words_.back().ends_with('\\') && position_ < text_.size()) {
      words_.back().remove_suffix(1);
      if (words_.back().empty()) words_.pop_back();
      split(take_line());
    }
  }
  return true;
}

void TextLines::need(std::string_view expected) {
  if (!next()) fail("the file ends where " + std::string(expected) + " should follow");
}

double TextLines::number(std::string_view word) const {
  double value = 0;
  if (!parse_number(word, value)) fail(quoted(word) + " is not a finite number");
  return value;
}

double TextLines::any_number(std::string_view word) const {
  double value = 0;
  if (!parse_any_number(word, value)) fail(quoted(word) + " is not a number");
  return value;
}

std::int64_t TextLines::integer(std::string_view word) const {
  if (word.starts_with('+')) word.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) fail(quoted(word) + " is not an integer");
  return value;
}

}  // namespace quoin::io
