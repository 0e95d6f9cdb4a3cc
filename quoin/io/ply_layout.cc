// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/ply_layout.h"

#include <algorithm>
#include <iterator>

#include "quoin/base/error.h"

namespace quoin::io {

namespace {

std::optional<PlyType> type_named(std::string_view name) {
  struct Name {
    std::string_view text;
    PlyType type;
  };
  static constexpr Name names[] = {
      {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
      {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
      {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
      {"float64", PlyType::float64}};
  const auto found = std::find_if(std::begin(names), std::end(names), [&](const Name& n) { return n.text == name; });
  return found == std::end(names) ? std::nullopt : std::optional(found->type);
}

class LayoutReader {
 public:
  LayoutReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  PlyLayout run() {
    if (take_line() != "ply") fail("'ply' should stand here");
    bool has_format = false;
    while (true) {
      const std::vector<std::string> words = words_of(take_line());
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") break;
      if (words[0] == "format" && words.size() > 1) {
        has_format = true;
        layout_.format = format(words[1]);
      } else if (words[0] == "element" && words.size() == 3) {
        layout_.elements.push_back({words[1], count(words[2]), {}});
      } else if (words[0] == "property" && !layout_.elements.empty()) {
        layout_.elements.back().properties.push_back(property(words));
      } else {
        fail("'" + words[0].substr(0, 40) + "' does not belong here");
      }
    }
    if (!has_format) fail("the header names no format");
    return std::move(layout_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(name_ + ":" + std::to_string(layout_.lines) + ": " + what);
  }

  std::string_view take_line() {
    const std::size_t end = bytes_.find_first_of("\r\n", layout_.size);
    ++layout_.lines;
    if (end == std::string_view::npos) fail("the file ends within the header");
    const std::string_view line = bytes_.substr(layout_.size, end - layout_.size);
    const bool pair = bytes_[end] == '\r' && end + 1 < bytes_.size() && bytes_[end + 1] == '\n';
    layout_.size = end + (pair ? 2 : 1);
    return line;
  }

  static std::vector<std::string> words_of(std::string_view line) {
    std::vector<std::string> words;
    std::size_t i = 0;
    while ((i = line.find_first_not_of(" \t", i)) != std::string_view::npos) {
      const std::size_t end = std::min(line.find_first_of(" \t", i), line.size());
      words.emplace_back(line.substr(i, end - i));
      i = end;
    }
    return words;
  }

  MeshFormat format(const std::string& word) const {
    if (word == "ascii") return MeshFormat::ply_text;
    if (word == "binary_little_endian") return MeshFormat::ply_binary_little;
    if (word == "binary_big_endian") return MeshFormat::ply_binary_big;
    fail("format '" + word.substr(0, 40) + "' is not known");
  }

  std::uint64_t count(const std::string& word) const {
    if (word.empty() || word.size() > 18 || word.find_first_not_of("0123456789") != std::string::npos) {
      fail("'" + word.substr(0, 40) + "' is not a count");
    }
    return std::stoull(word);
  }

  PlyProperty property(const std::vector<std::string>& words) const {
    if (words.size() == 3) {
      const auto type = type_named(words[1]);
      if (type) return {words[2], *type, std::nullopt};
    }
    if (words.size() == 5 && words[1] == "list") {
      const auto count_type = type_named(words[2]);
      const auto type = type_named(words[3]);
      if (count_type && type && *count_type != PlyType::float32 && *count_type != PlyType::float64)
        return {words[4], *type, count_type};
    }
    fail("this property is not understood");
  }

  std::string_view bytes_;
  std::string name_;
  PlyLayout layout_;
};

}  // namespace

std::size_t size_of(PlyType type) {
  static constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const PlyProperty& p) { return p.name == property && !p.count_type; });
  if (found == properties.end()) return std::nullopt;
  return static_cast<std::size_t>(found - properties.begin());
}

PlyLayout read_ply_layout(std::string_view bytes, const std::string& name) {
  return LayoutReader(bytes, name).run();
}

}  // namespace quoin::io
