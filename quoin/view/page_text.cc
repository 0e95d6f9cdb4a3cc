// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/page_text.h"

#include "quoin/base/error.h"
#include "quoin/view/page_format.h"

namespace quoin::page_text {

namespace {

/// Length of the UTF-8 character at the beginning of a text that XML may hold; zero if there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' ? 1 : 0;
  const std::size_t length = first >= 0xF0 && first < 0xF5   ? 4
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xC2 && first < 0xE0 ? 2
                                                             : 0;
  if (length == 0) return 0;
  unsigned code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = code << 6 | (byte(i) & 0x3FU);
  }
  const bool is_overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool is_unpaired = code >= 0xD800 && code < 0xE000;
  return is_overlong || is_unpaired || code > 0x10FFFF || code == 0xFFFE || code == 0xFFFF ? 0 : length;
}

}  // namespace

void write_json_string(std::ostream& out, std::string_view text) {
  constexpr char digits[] = "0123456789abcdef";
  out << '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || c == '<' || c == '"' || c == '\\') {
      out << "\\u00" << digits[byte >> 4] << digits[byte & 15];
    } else {
      out << c;
    }
  }
  out << '"';
}

void write_json_facts(std::ostream& out, const std::vector<ViewFact>& facts) {
  write_json_list(out, facts, [&](const ViewFact& fact) {
    out << '[';
    write_json_string(out, fact.first);
    out << ',';
    write_json_string(out, fact.second);
    out << ']';
  });
}

void write_title(std::ostream& out, std::string_view title) {
  for (const char c : title.empty() ? std::string_view("Quoin") : title) {
    if (c == '<')
      out << "&lt;";
    else if (c == '&')
      out << "&amp;";
    else if (c != '\0')
      out << c;
  }
}

void write_xml(std::ostream& out, std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const char c = text.front();
    if (length == 0)
      out << "\xEF\xBF\xBD";
    else if (c == '<')
      out << "&lt;";
    else if (c == '>')
      out << "&gt;";
    else if (c == '&')
      out << "&amp;";
    else if (c == '"')
      out << "&quot;";
    else
      out << text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
}

Template split_template(std::string_view page_template) {
  const std::size_t title = page_template.find(page_format::title_marker);
  const std::size_t data = page_template.find(page_format::scene_marker);
  if (title == std::string_view::npos || data == std::string_view::npos || data < title) {
    throw InternalError("view: the page template lacks its markers");
  }
  const std::size_t after_title = title + page_format::title_marker.size();
  return {page_template.substr(0, title), page_template.substr(after_title, data - after_title),
          page_template.substr(data + page_format::scene_marker.size())};
}

}  // namespace quoin::page_text
