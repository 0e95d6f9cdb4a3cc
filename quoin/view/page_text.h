// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <charconv>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/view/scene.h"

/// Text as it may stand in a page, whatever the stream's flags and locale are.
namespace quoin::page_text {

template <class Number>
void write_number(std::ostream& out, Number value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  out.write(text.data(), end - text.data());
}

/// A JSON string in which no '<' can end the script element that holds it.
void write_json_string(std::ostream& out, std::string_view text);

template <class List, class Write>
void write_json_list(std::ostream& out, const List& list, const Write& write) {
  out << '[';
  const char* separator = "";
  for (const auto& item : list) {
    out << separator;
    write(item);
    separator = ",";
  }
  out << ']';
}

/// Pairs of strings.
void write_json_facts(std::ostream& out, const std::vector<ViewFact>& facts);

/// Of an HTML title element.
void write_title(std::ostream& out, std::string_view title);

/// Text or attribute value of XML: markup is escaped, and what XML cannot hold (control characters, bytes that are not
/// UTF-8) becomes U+FFFD.
void write_xml(std::ostream& out, std::string_view text);

/// The parts of a page template around its two markers.
struct Template {
  std::string_view before_title;
  std::string_view before_scene;
  std::string_view rest;
};

/// @throws InternalError  a marker is missing
Template split_template(std::string_view page_template);

}  // namespace quoin::page_text
