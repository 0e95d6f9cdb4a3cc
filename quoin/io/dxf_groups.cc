// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/dxf_groups.h"

#include <algorithm>
#include <charconv>

#include "quoin/io/drawing_text.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

std::string_view trimmed(std::string_view text) {
  static constexpr std::string_view space = " \t\v\f";
  const std::size_t begin = std::min(text.find_first_not_of(space), text.size());
  const std::size_t end = text.find_last_not_of(space);
  return end == std::string_view::npos ? std::string_view() : text.substr(begin, end + 1 - begin);
}

}  // namespace

DxfGroups::DxfGroups(std::string_view text, const std::string& name)
    : text_(TextCursor(text, name).text()), name_(name) {
  if (text_.starts_with("AutoCAD Binary DXF")) fail_at(1, "", "binary DXF is not read");
}

std::string_view DxfGroups::take_line() {
  if (position_ >= text_.size()) fail("", "the file ends before EOF");
  ++line_;
  const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
  const std::string_view line = text_.substr(position_, end - position_);
  const bool is_pair = text_.substr(end).starts_with("\r\n");
  position_ = std::min(end + (is_pair ? 2 : 1), text_.size());
  return trimmed(line);
}

void DxfGroups::next() {
  do {
    const std::string_view code = take_line();
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), code_);
    if (error != std::errc() || end != code.data() + code.size()) {
      code_ = -1;
      fail("", quoted(code) + " is no group code");
    }
    value_ = take_line();
  } while (code_ == 999);
}

double DxfGroups::number(std::string_view element) const {
  double value = 0;
  if (number_length(value_) != value_.size() || !parse_number(value_, value))
    fail(element, quoted(value_) + " (group " + std::to_string(code_) + ") is not a finite number");
  return plain(value);
}

std::int64_t DxfGroups::integer(std::string_view element) const {
  std::string_view digits = value_;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size())
    fail(element, quoted(value_) + " (group " + std::to_string(code_) + ") is not an integer");
  return value;
}

void DxfGroups::expect_end() {
  while (position_ < text_.size()) {
    if (!take_line().empty()) fail("", "nothing should follow EOF");
  }
}

void DxfGroups::fail_at(std::size_t line, std::string_view element, std::string_view what) const {
  fail_in_text(name_, line, element, what);
}

}  // namespace quoin::io
