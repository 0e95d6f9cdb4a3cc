// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/drawing_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "quoin/base/error.h"
#include "quoin/io/text_lines.h"
#include "quoin/number/error_free.h"
#include "quoin/number/interval.h"

namespace quoin::io {

namespace {

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::size_t digits_length(std::string_view text, std::size_t from) {
  std::size_t i = from;
  while (i < text.size() && text[i] >= '0' && text[i] <= '9') ++i;
  return i - from;
}

}  // namespace

std::size_t number_length(std::string_view text) {
  std::size_t i = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  const std::size_t whole = digits_length(text, i);
  i += whole;
  if (i < text.size() && text[i] == '.') {
    const std::size_t fraction = digits_length(text, i + 1);
    if (whole == 0 && fraction == 0) return 0;
    i += 1 + fraction;
  } else if (whole == 0) {
    return 0;
  }
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    std::size_t k = i + 1;
    if (k < text.size() && (text[k] == '+' || text[k] == '-')) ++k;
    const std::size_t exponent = digits_length(text, k);
    if (exponent > 0) i = k + exponent;
  }
  return i;
}

std::size_t line_of(std::string_view text, std::size_t position) {
  std::size_t line = 1;
  for (std::size_t i = 0; i < std::min(position, text.size()); ++i) {
    if (text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'))) ++line;
  }
  return line;
}

void fail_in_text(const std::string& name, std::size_t line, std::string_view element, std::string_view what) {
  std::string message = name + ":" + std::to_string(line) + ": ";
  for (const char c : element) message += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  if (!element.empty()) message += ": ";
  throw InputError(message + std::string(what));
}

TextCursor::TextCursor(std::string_view text, const std::string& name) : text_(text), name_(name) {
  if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
}

void TextCursor::skip_space() {
  while (position_ < text_.size() && is_space(text_[position_])) ++position_;
}

bool TextCursor::accept(char c) {
  skip_space();
  if (at_end() || text_[position_] != c) return false;
  ++position_;
  return true;
}

bool TextCursor::skip_comma() {
  const bool is_there = accept(',');
  skip_space();
  return is_there;
}

std::string_view TextCursor::word() {
  skip_space();
  const std::size_t begin = position_;
  while (position_ < text_.size() && is_letter(text_[position_])) ++position_;
  return text_.substr(begin, position_ - begin);
}

double TextCursor::number(std::string_view element) {
  skip_space();
  const std::size_t length = number_length(rest());
  if (length == 0) fail(element, "a number should stand here, and " + found() + " does");
  const std::string_view digits = text_.substr(position_, length);
  double value = 0;
  if (!parse_number(digits, value)) fail(element, quoted(digits) + " is beyond the largest double");
  position_ += length;
  return plain(value);
}

void TextCursor::fail_at(std::size_t position, std::string_view element, std::string_view what) const {
  fail_in_text(name_, line_of(text_, position), element, what);
}

std::string TextCursor::found() const {
  if (at_end()) return "the end of the text";
  std::string_view next = rest().substr(0, 20);
  const std::size_t end = next.find_first_of(" \t\r\n,()<>", 1);
  return quoted(next.substr(0, end));
}

void RunningSum::set(double value) {
  value_ = value;
  tail_ = 0;
  exact_.reset();
}

void RunningSum::add(double value) {
  if (!std::isfinite(value_)) return;
  if (!exact_) {
    const TwoDoubles sum = two_sum(value_, value);
    const TwoDoubles tails = two_sum(tail_, sum.tail);
    if (std::isfinite(sum.value) && tails.tail == 0) {
      const TwoDoubles both = two_sum(sum.value, tails.value);
      value_ = plain(both.value);
      tail_ = both.tail;
      return;
    }
    exact_ = Rational(value_) + Rational(tail_);
  }
  *exact_ += Rational(value);
  value_ = exact_->to_double();
  if (!std::isfinite(value_)) return;
  const Rational rest = *exact_ - Rational(value_);
  tail_ = rest.to_double();
  if (Rational(tail_) == rest) exact_.reset();
}

double RunningSum::error() const {
  return exact_ ? Interval::around(abs(*exact_ - Rational(value_))).upper() : std::fabs(tail_);
}

void DrawingNotes::add(std::string_view remark, std::string_view element, double distance, bool has_distance) {
  auto entry = index_.find(remark);
  if (entry == index_.end()) {
    entry = index_.emplace(remark, notes_.size()).first;
    notes_.push_back({std::string(remark), std::string(element)});
  }
  Note& note = notes_[entry->second];
  ++note.count;
  note.has_distance |= has_distance;
  note.distance = std::max(note.distance, distance);
}

std::vector<std::string> DrawingNotes::list() const {
  std::vector<std::string> lines;
  for (const Note& note : notes_) {
    std::string line = note.remark + ": " + std::to_string(note.count);
    if (!note.first.empty()) line += note.count == 1 ? " (" + note.first + ")" : " (first " + note.first + ")";
    if (note.has_distance) line += ", by at most " + upper_decimals(note.distance);
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string decimals(double value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), plain(value)).ptr;
  return {digits.data(), end};
}

std::string upper_decimals(double value) {
  if (value == 0) return "0";
  // A hundredth more is above half a unit of the third digit; the smallest doubles gain nothing by it.
  const double more = value < 1e-300 ? 1e-300 : value * 1.01;
  if (!std::isfinite(more)) return "infinity";
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), more, std::chars_format::general, 3).ptr;
  return {digits.data(), end};
}

}  // namespace quoin::io
