// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/xml_tags.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

constexpr std::array<std::pair<std::string_view, char>, 5> references = {
    {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == ':' ||
         c == '-' || c == '.' || static_cast<unsigned char>(c) >= 0x80;
}

void append_utf8(std::string& text, unsigned code) {
  const auto tail = [&](unsigned shift) { text += static_cast<char>(0x80 | ((code >> shift) & 0x3F)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0 | (code >> 6));
    tail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0 | (code >> 12));
    tail(6);
    tail(0);
  } else {
    text += static_cast<char>(0xF0 | (code >> 18));
    tail(12);
    tail(6);
    tail(0);
  }
}

// The character that "&#...;" at the begin of a text stands for, and its length; 0 if it is none.
std::size_t numeric_reference(std::string_view text, unsigned& code) {
  const std::size_t end = text.substr(0, 12).find(';');
  if (!text.starts_with("&#") || end == std::string_view::npos) return 0;
  const bool is_hexadecimal = text.size() > 2 && (text[2] == 'x' || text[2] == 'X');
  const char* first = text.data() + (is_hexadecimal ? 3 : 2);
  const char* last = text.data() + end;
  if (first >= last) return 0;
  const auto [at, error] = std::from_chars(first, last, code, is_hexadecimal ? 16 : 10);
  const bool is_character = code < 0x110000 && (code < 0xD800 || code > 0xDFFF);
  return error == std::errc() && at == last && is_character ? end + 1 : 0;
}

}  // namespace

const XmlAttribute* XmlTag::find(std::string_view attribute) const {
  const auto found = std::ranges::find(attributes, attribute, &XmlAttribute::name);
  return found == attributes.end() ? nullptr : &*found;
}

bool XmlTags::next(XmlTag& tag) {
  do {
    const std::size_t begin = cursor_.text().find('<', cursor_.position());
    if (begin == std::string_view::npos) return false;
    cursor_.move_to(begin);
  } while (skip_markup());
  tag.position = cursor_.position();
  tag.attributes.clear();
  tag.is_empty = false;
  cursor_.move_to(cursor_.position() + 1);
  tag.is_end = cursor_.peek() == '/';
  if (tag.is_end) cursor_.move_to(cursor_.position() + 1);
  tag.name = name();
  if (tag.name.empty()) cursor_.fail("", "the name of a tag should stand here, and " + cursor_.found() + " does");
  if (tag.name.starts_with(prefix_)) tag.name.remove_prefix(prefix_.size());
  for (;;) {
    cursor_.skip_space();
    if (cursor_.at_end()) cursor_.fail_at(tag.position, "", "the tag " + quoted(tag.name) + " does not end");
    if (cursor_.accept('>')) return true;
    if (!tag.is_end && cursor_.rest().starts_with("/>")) {
      tag.is_empty = true;
      cursor_.move_to(cursor_.position() + 2);
      return true;
    }
    attribute(tag);
  }
}

// Skips what begins with '<' and is no tag; whether there was any.
bool XmlTags::skip_markup() {
  const std::string_view rest = cursor_.rest();
  if (rest.starts_with("<!--")) {
    skip_past("-->", "comment");
  } else if (rest.starts_with("<![CDATA[")) {
    skip_past("]]>", "CDATA section");
  } else if (rest.starts_with("<?")) {
    skip_past("?>", "processing instruction");
  } else if (rest.starts_with("<!")) {
    skip_document_type();
  } else {
    return false;
  }
  return true;
}

void XmlTags::skip_past(std::string_view end, std::string_view what) {
  const std::size_t found = cursor_.text().find(end, cursor_.position() + 2);
  if (found == std::string_view::npos) cursor_.fail("", "a " + std::string(what) + " does not end");
  cursor_.move_to(found + end.size());
}

// <!DOCTYPE ... [ ... ]>, with quoted '>' in it.
void XmlTags::skip_document_type() {
  const std::string_view text = cursor_.text();
  bool in_subset = false;
  char quote = '\0';
  for (std::size_t i = cursor_.position(); i < text.size(); ++i) {
    const char c = text[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == ']') {
      in_subset = c == '[';
    } else if (c == '>' && !in_subset) {
      return cursor_.move_to(i + 1);
    }
  }
  cursor_.fail("", "a document type does not end");
}

std::string_view XmlTags::name() {
  const std::string_view rest = cursor_.rest();
  std::size_t length = 0;
  while (length < rest.size() && is_name_character(rest[length])) ++length;
  cursor_.move_to(cursor_.position() + length);
  return rest.substr(0, length);
}

void XmlTags::attribute(XmlTag& tag) {
  const std::string_view attribute_name = name();
  if (tag.is_end || attribute_name.empty())
    cursor_.fail("", cursor_.found() + " does not belong into the tag " + quoted(tag.name));
  if (!cursor_.accept('=')) cursor_.fail("", "'=' is missing behind the attribute " + quoted(attribute_name));
  cursor_.skip_space();
  const char quote = cursor_.peek();
  if (quote != '"' && quote != '\'') cursor_.fail("", "the attribute " + quoted(attribute_name) + " is not in quotes");
  const std::size_t begin = cursor_.position() + 1;
  const std::size_t end = cursor_.text().find(quote, begin);
  if (end == std::string_view::npos) cursor_.fail("", "the attribute " + quoted(attribute_name) + " does not end");
  if (tag.attributes.size() >= 1000) cursor_.fail("", "the tag " + quoted(tag.name) + " has too many attributes");
  if (tag.find(attribute_name) != nullptr)
    cursor_.fail("", "the attribute " + quoted(attribute_name) + " is there twice");
  tag.attributes.push_back({attribute_name, cursor_.text().substr(begin, end - begin), begin});
  cursor_.move_to(end + 1);
}

std::string xml_decoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != '&') {
      result += text[i++];
      continue;
    }
    unsigned code = 0;
    if (const std::size_t length = numeric_reference(text.substr(i), code); length > 0) {
      append_utf8(result, code);
      i += length;
      continue;
    }
    const auto named = std::ranges::find_if(
        references, [rest = text.substr(i)](const auto& reference) { return rest.starts_with(reference.first); });
    result += named == references.end() ? '&' : named->second;
    i += named == references.end() ? 1 : named->first.size();
  }
  return result;
}

std::string xml_encoded(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto named = std::ranges::find(references, c, [](const auto& reference) { return reference.second; });
    if (named != references.end()) {
      result += named->first;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      result += "&#" + std::to_string(static_cast<unsigned char>(c)) + ";";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace quoin::io
