// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/threemf_relationships.h"

#include <charconv>

#include "quoin/io/threemf_xml.h"

namespace quoin::io {

namespace {

constexpr std::string_view model_type = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

// With %XX replaced; others stay.
std::string uri_decoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    if (text[i] == '%' && i + 2 < text.size()) {
      const auto [end, error] = std::from_chars(&text[i + 1], &text[i + 1] + 2, code, 16);
      if (error == std::errc() && end == &text[i + 1] + 2) {
        result += static_cast<char>(code);
        i += 2;
        continue;
      }
    }
    result += text[i];
  }
  return result;
}

}  // namespace

std::optional<std::string> threemf_model_path(std::string_view text, const std::string& name, const Context& context) {
  ThreemfXml xml(text, name, context);
  std::optional<std::string> path;
  xml.root();
  xml.children([&] {
    const XmlTag& tag = xml.tag();
    const XmlAttribute* type = tag.find("Type");
    if (type != nullptr && type->value == model_type) {
      const XmlAttribute* mode = tag.find("TargetMode");
      if (mode != nullptr && mode->value != "Internal") xml.fail("the model is not in the package");
      std::string target = uri_decoded(xml_decoded(xml.required("Target").value));
      target.erase(0, target.find_first_not_of('/'));
      if (target.empty()) xml.fail("the relationship names no part");
      if (path && *path != target) xml.fail("two relationships name models");
      path = target;
    }
    xml.skip();
  });
  xml.end();
  return path;
}

}  // namespace quoin::io
