// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/threemf_xml.h"

#include <charconv>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
}

}  // namespace

ThreemfXml::ThreemfXml(std::string_view text, const std::string& name, const Context& context)
    : cursor_(text, name), tags_(cursor_), context_(context) {
  const bool is_wide = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
                       text.starts_with(std::string_view("<\0", 2)) || text.starts_with(std::string_view("\0<", 2));
  if (is_wide) throw InputError(name + ": UTF-16 is not read, only UTF-8");
}

void ThreemfXml::root() {
  if (!tags_.next(tag_)) cursor_.fail_at(0, "", "there is no element");
  if (tag_.is_end) fail("an end tag before any start tag");
}

bool ThreemfXml::next_in(std::string_view parent) {
  if (++tag_count_ % 2048 == 0) context_.poll();
  if (!tags_.next(tag_))
    cursor_.fail_at(cursor_.text().size(), "", "the element " + io::quoted(parent) + " does not end");
  if (tag_.is_end && tag_.name != parent) {
    fail("</" + std::string(tag_.name.substr(0, 40)) + "> closes no element; the one to be closed is " +
         io::quoted(parent));
  }
  return !tag_.is_end;
}

void ThreemfXml::skip() {
  if (tag_.is_empty) return;
  std::vector<std::string_view> open{tag_.name};
  while (!open.empty()) {
    if (!next_in(open.back())) {
      open.pop_back();
    } else if (!tag_.is_empty) {
      open.push_back(tag_.name);
    }
  }
}

void ThreemfXml::end() {
  if (tags_.next(tag_)) fail("nothing should stand behind the root element");
}

const XmlAttribute& ThreemfXml::required(std::string_view attribute) const {
  const XmlAttribute* found = tag_.find(attribute);
  if (found == nullptr) fail("the element " + io::quoted(tag_.name) + " has no attribute " + io::quoted(attribute));
  return *found;
}

double ThreemfXml::number(const XmlAttribute& attribute) const {
  double value = 0;
  if (!parse_number(trimmed(attribute.value), value))
    fail(io::quoted(attribute.value) + " for " + io::quoted(attribute.name) + " is not a finite number");
  return value;
}

std::uint32_t ThreemfXml::index(std::string_view attribute) const {
  const std::string_view word = trimmed(required(attribute).value);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || word.empty())
    fail(io::quoted(word) + " for " + io::quoted(attribute) + " is no index");
  return value;
}

std::size_t ThreemfXml::line() {
  const std::string_view text = cursor_.text();
  line_ += line_of(text.substr(counted_, tag_.position - counted_ + 1), tag_.position - counted_) - 1;
  counted_ = tag_.position;
  return line_;
}

void ThreemfXml::fail(std::string_view what) const {
  cursor_.fail_at(tag_.position, "", what);
}

}  // namespace quoin::io
