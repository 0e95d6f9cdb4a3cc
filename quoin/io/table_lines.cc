// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/table_lines.h"

#include <algorithm>

#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

constexpr std::string_view blanks = " \t\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

}  // namespace

Separator separator_of(std::string_view line) {
  bool is_quoted = false;
  bool has_comma = false;
  bool has_tab = false;
  bool has_inner_blank = false;
  char last = '\t';  // that is no blank
  bool is_behind_blank = false;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    if (is_quoted) continue;
    if (c == ';') return Separator::semicolon;
    has_comma = has_comma || c == ',';
    has_tab = has_tab || c == '\t';
    if (c == ' ') {
      is_behind_blank = true;
      continue;
    }
    has_inner_blank = has_inner_blank || (is_behind_blank && last != '\t' && c != '\t');
    is_behind_blank = false;
    last = c;
  }
  if (has_comma) return Separator::comma;
  return has_tab && !has_inner_blank ? Separator::tab : Separator::blank;
}

TableLines::TableLines(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

bool TableLines::next() {
  while (!rest_.empty()) {
    ++number_;
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line_ = trimmed(rest_.substr(0, end));
    const bool pair = end + 1 < rest_.size() && rest_[end] == '\r' && rest_[end + 1] == '\n';
    rest_.remove_prefix(std::min(end + (pair ? 2 : 1), rest_.size()));
    if (line_.empty()) continue;
    if (line_[0] != '#' && !line_.starts_with("//")) return true;
    comment_ = trimmed(line_.substr(line_[0] == '#' ? 1 : 2));
  }
  return false;
}

std::string_view TableLines::take_field(std::size_t& at, Separator separator) const {
  const auto is_end = [&](char c) {
    return separator == Separator::blank ? c == ' ' || c == '\t' : c == static_cast<char>(separator);
  };
  std::size_t begin = at;
  while (begin < line_.size() && line_[begin] == ' ') ++begin;
  if (begin == line_.size() || line_[begin] != '"') {
    while (at < line_.size() && !is_end(line_[at])) ++at;
    return trimmed(line_.substr(begin, at > begin ? at - begin : 0));
  }
  std::size_t close = begin + 1;
  while (true) {
    close = line_.find('"', close);
    if (close == std::string_view::npos) fail("a quote is not closed on its line");
    if (close + 1 == line_.size() || line_[close + 1] != '"') break;
    close += 2;  // two stand for one
  }
  at = close + 1;
  while (at < line_.size() && !is_end(line_[at])) {
    if (line_[at] != ' ' && line_[at] != '\t') fail("a field goes on behind its quotes");
    ++at;
  }
  return trimmed(line_.substr(begin + 1, close - begin - 1));
}

void TableLines::split(Separator separator, std::vector<std::string_view>& fields) const {
  fields.clear();
  std::size_t at = 0;
  while (at < line_.size()) {
    fields.push_back(take_field(at, separator));
    ++at;  // the separator
    while (separator == Separator::blank && at < line_.size() && (line_[at] == ' ' || line_[at] == '\t')) ++at;
  }
}

void TableLines::fail(std::string_view what) const {
  throw LineError(name_ + ":" + std::to_string(number_) + ": " + std::string(what));
}

}  // namespace quoin::io
