// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "quoin/io/drawing_text.h"

namespace quoin::io {

/// An attribute as it is written, at a position of the text.
struct XmlAttribute {
  std::string_view name;
  std::string_view value;
  std::size_t position = 0;
};

struct XmlTag {
  std::string_view name;  ///< without the prefix that the reader leaves out
  std::vector<XmlAttribute> attributes;
  std::size_t position = 0;
  bool is_end = false;    ///< </name>
  bool is_empty = false;  ///< <name/>

  const XmlAttribute* find(std::string_view attribute) const;
};

/// Start and end tags of an XML document in their order; text, comments, CDATA, processing instructions and document
/// types are skipped. No entities are read but in `xml_decoded`. The prefix, with its colon, is left out where a tag's
/// name begins with it.
class XmlTags {
 public:
  explicit XmlTags(TextCursor& cursor, std::string_view prefix = {}) : cursor_(cursor), prefix_(prefix) {}
  /// False at the end. @throws InputError  what is not well formed
  bool next(XmlTag& tag);

 private:
  bool skip_markup();
  void skip_past(std::string_view end, std::string_view what);
  void skip_document_type();
  std::string_view name();
  void attribute(XmlTag& tag);

  TextCursor& cursor_;
  std::string_view prefix_;
};

/// With the five named references and those by number replaced; others stay.
std::string xml_decoded(std::string_view text);
/// Fit for an attribute in double quotes.
std::string xml_encoded(std::string_view text);

}  // namespace quoin::io
