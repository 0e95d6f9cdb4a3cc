// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "quoin/base/context.h"
#include "quoin/io/drawing_text.h"
#include "quoin/io/xml_tags.h"

namespace quoin::io {

/// Walks over the elements of an XML text, with numbers as attributes and errors with lines.
class ThreemfXml {
 public:
  /// All must outlive it. @throws InputError  the text is in UTF-16
  ThreemfXml(std::string_view text, const std::string& name, const Context& context);

  /// Goes to the first start tag. @throws InputError  there is none
  void root();
  /// The tag that was read last.
  const XmlTag& tag() const { return tag_; }
  /// Calls `visit` for each element in the one whose start tag was read last; it must leave none of it unread.
  template <class Visit>
  void children(const Visit& visit) {
    if (tag_.is_empty) return;
    const std::string_view parent = tag_.name;
    while (next_in(parent)) visit();
  }
  /// Passes over the element whose start tag was read last.
  void skip();
  /// Behind the root there may be no other element.
  void end();

  /// @throws InputError  the attribute is missing
  const XmlAttribute& required(std::string_view attribute) const;
  /// @throws InputError  no finite number
  double number(const XmlAttribute& attribute) const;
  /// An attribute's number. @throws InputError  it is missing or no such number
  double number(std::string_view attribute) const { return number(required(attribute)); }
  /// A number of 32 bits without sign. @throws InputError  as above
  std::uint32_t index(std::string_view attribute) const;

  /// Of the tag that was read last. Linear in what was read since the last call.
  std::size_t line();
  /// At the tag that was read last.
  [[noreturn]] void fail(std::string_view what) const;

 private:
  bool next_in(std::string_view parent);

  TextCursor cursor_;
  XmlTags tags_;
  const Context& context_;
  XmlTag tag_;
  std::size_t tag_count_ = 0;
  std::size_t counted_ = 0;  // text before that has `line_` - 1 ends of lines
  std::size_t line_ = 1;
};

}  // namespace quoin::io
