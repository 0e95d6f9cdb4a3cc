// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "quoin/io/readers.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::optional<Type> type_named(std::string_view name) {
  struct Name {
    std::string_view text;
    Type type;
  };
  static constexpr Name names[] = {
      {"char", Type::int8},     {"int8", Type::int8},       {"uchar", Type::uint8},    {"uint8", Type::uint8},
      {"short", Type::int16},   {"int16", Type::int16},     {"ushort", Type::uint16},  {"uint16", Type::uint16},
      {"int", Type::int32},     {"int32", Type::int32},     {"uint", Type::uint32},    {"uint32", Type::uint32},
      {"float", Type::float32}, {"float32", Type::float32}, {"double", Type::float64}, {"float64", Type::float64}};
  const auto found = std::find_if(std::begin(names), std::end(names), [&](const Name& n) { return n.text == name; });
  return found == std::end(names) ? std::nullopt : std::optional(found->type);
}

std::size_t size_of(Type type) {
  static constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count_type;  // of a list
};

struct Element {
  std::string name;
  std::uint64_t count;
  std::vector<Property> properties;
};

struct Header {
  MeshFormat format = MeshFormat::ply_text;
  std::vector<Element> elements;
  std::size_t size = 0;  // bytes
  std::size_t lines = 0;
};

// The values of a file's body, one after the other, text or binary.
class Values {
 public:
  Values(std::string_view body, const Header& header, std::string name)
      : body_(body), name_(std::move(name)), offset_(header.size), line_(header.lines), format_(header.format) {}

  std::size_t remaining() const { return body_.size() - position_; }

  double next(Type type) { return format_ == MeshFormat::ply_text ? next_word() : next_binary(type); }

  /// Ends an element: in text, each has a line.
  void end_element() {
    if (format_ != MeshFormat::ply_text) return;
    position_ = std::min(body_.find_first_not_of(" \t\v\f", position_), body_.size());
    if (position_ < body_.size() && body_[position_] != '\n' && body_[position_] != '\r')
      fail("the line goes on behind the values of its element");
  }

  /// The line or byte of the next value, or nothing where none is left.
  std::optional<std::string> place_of_next() {
    if (format_ == MeshFormat::ply_text) skip_space();
    if (remaining() == 0) return std::nullopt;
    return format_ == MeshFormat::ply_text ? "line " + std::to_string(line_ + 1)
                                           : "byte " + std::to_string(offset_ + position_);
  }

  [[noreturn]] void fail(const std::string& what) const {
    if (format_ == MeshFormat::ply_text) throw InputError(name_ + ":" + std::to_string(line_ + 1) + ": " + what);
    throw InputError(name_ + ": byte " + std::to_string(offset_ + position_) + ": " + what);
  }

 private:
  void skip_space() {
    while (position_ < body_.size() && std::strchr(" \t\r\n\v\f", body_[position_]) != nullptr &&
           body_[position_] != '\0') {
      const bool pair = body_[position_] == '\r' && position_ + 1 < body_.size() && body_[position_ + 1] == '\n';
      if (body_[position_] == '\n' || (body_[position_] == '\r' && !pair)) ++line_;
      ++position_;
    }
  }

  double next_word() {
    skip_space();
    const std::size_t end = std::min(body_.find_first_of(" \t\r\n\v\f", position_), body_.size());
    if (end == position_) fail("the file ends within its elements");
    const std::string_view word = body_.substr(position_, end - position_);
    double value = 0;
    if (!parse_number(word, value)) fail("'" + std::string(word.substr(0, 40)) + "' is not a finite number");
    position_ = end;
    return value;
  }

  template <class T>
  double decode() {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), body_.data() + position_, sizeof(T));
    const bool swap = (format_ == MeshFormat::ply_binary_big) == (std::endian::native == std::endian::little);
    if (swap) std::reverse(bytes.begin(), bytes.end());
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return static_cast<double>(value);
  }

  double next_binary(Type type) {
    if (remaining() < size_of(type)) fail("the file ends within its elements");
    double value = 0;
    switch (type) {
      case Type::int8:
        value = decode<std::int8_t>();
        break;
      case Type::uint8:
        value = decode<std::uint8_t>();
        break;
      case Type::int16:
        value = decode<std::int16_t>();
        break;
      case Type::uint16:
        value = decode<std::uint16_t>();
        break;
      case Type::int32:
        value = decode<std::int32_t>();
        break;
      case Type::uint32:
        value = decode<std::uint32_t>();
        break;
      case Type::float32:
        value = decode<float>();
        break;
      case Type::float64:
        value = decode<double>();
        break;
    }
    position_ += size_of(type);
    return value;
  }

  std::string_view body_;
  std::string name_;
  std::size_t offset_;
  std::size_t line_;
  MeshFormat format_;
  std::size_t position_ = 0;
};

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& name, const Context& context)
      : bytes_(bytes), name_(name), context_(context) {}

  MeshFile run() {
    read_header();
    file_.report.format = header_.format;
    Values values(bytes_.substr(header_.size), header_, name_);
    for (const Element& element : header_.elements) {
      if (element.properties.empty()) continue;
      if (element.count > values.remaining()) {
        values.fail("a count of " + std::to_string(element.count) + " " + element.name +
                    " does not fit the file's size");
      }
      if (element.name == "vertex") {
        read_vertices(element, values);
      } else if (element.name == "face") {
        read_faces(element, values);
      } else {
        skip(element, values);
      }
    }
    if (const auto place = values.place_of_next())
      file_.report.warnings.push_back(*place + ": what follows the last element is not kept");
    if (!has_colors_) file_.mesh.face_colors.clear();
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail_header(const std::string& what) const {
    throw InputError(name_ + ":" + std::to_string(header_.lines) + ": " + what);
  }

  std::string_view take_header_line() {
    const std::size_t end = bytes_.find_first_of("\r\n", header_.size);
    ++header_.lines;
    if (end == std::string_view::npos) fail_header("the file ends within the header");
    const std::string_view line = bytes_.substr(header_.size, end - header_.size);
    const bool pair = bytes_[end] == '\r' && end + 1 < bytes_.size() && bytes_[end + 1] == '\n';
    header_.size = end + (pair ? 2 : 1);
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

  void read_header() {
    if (take_header_line() != "ply") fail_header("'ply' should stand here");
    bool has_format = false;
    while (true) {
      const std::vector<std::string> words = words_of(take_header_line());
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") break;
      if (words[0] == "format" && words.size() > 1) {
        has_format = true;
        if (words[1] == "ascii")
          header_.format = MeshFormat::ply_text;
        else if (words[1] == "binary_little_endian")
          header_.format = MeshFormat::ply_binary_little;
        else if (words[1] == "binary_big_endian")
          header_.format = MeshFormat::ply_binary_big;
        else
          fail_header("format '" + words[1].substr(0, 40) + "' is not known");
      } else if (words[0] == "element" && words.size() == 3) {
        header_.elements.push_back({words[1], count(words[2]), {}});
      } else if (words[0] == "property" && !header_.elements.empty()) {
        header_.elements.back().properties.push_back(property(words));
      } else {
        fail_header("'" + words[0].substr(0, 40) + "' does not belong here");
      }
    }
    if (!has_format) fail_header("the header names no format");
  }

  std::uint64_t count(const std::string& word) const {
    if (word.empty() || word.size() > 18 || word.find_first_not_of("0123456789") != std::string::npos) {
      fail_header("'" + word.substr(0, 40) + "' is not a count");
    }
    return std::stoull(word);
  }

  Property property(const std::vector<std::string>& words) const {
    if (words.size() == 3) {
      const auto type = type_named(words[1]);
      if (type) return {words[2], *type, std::nullopt};
    }
    if (words.size() == 5 && words[1] == "list") {
      const auto count_type = type_named(words[2]);
      const auto type = type_named(words[3]);
      if (count_type && type && *count_type != Type::float32 && *count_type != Type::float64)
        return {words[4], *type, count_type};
    }
    fail_header("this property is not understood");
  }

  // Calls take(property index, position in its list, value) for every value of one element.
  template <class Take>
  static void read_one(const Element& element, Values& values, const Take& take) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const Property& property = element.properties[p];
      std::size_t length = 1;
      if (property.count_type) {
        const double announced = values.next(*property.count_type);
        if (announced < 0 || announced > static_cast<double>(values.remaining()) ||
            announced != std::floor(announced)) {
          values.fail("a list of " + std::to_string(announced) + " values does not fit the file's size");
        }
        length = static_cast<std::size_t>(announced);
      }
      for (std::size_t i = 0; i < length; ++i) take(p, i, values.next(property.type));
    }
    values.end_element();
  }

  void read_vertices(const Element& element, Values& values) {
    std::array<std::size_t, 3> place{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string axis(1, "xyz"[k]);
      const auto found = std::find_if(element.properties.begin(), element.properties.end(),
                                      [&](const Property& p) { return p.name == axis && !p.count_type; });
      if (found == element.properties.end()) fail_header("the vertices have no " + axis);
      place[k] = static_cast<std::size_t>(found - element.properties.begin());
    }
    file_.mesh.vertices.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (i % 4096 == 0) context_.poll();
      Point3 point;
      read_one(element, values, [&](std::size_t p, std::size_t, double value) {
        for (std::size_t k = 0; k < 3; ++k) {
          if (p != place[k]) continue;
          if (!std::isfinite(value))
            values.fail("vertex " + std::to_string(i) + " has a coordinate that is not finite");
          point[k] = value;
        }
      });
      file_.mesh.vertices.push_back(point);
    }
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      if (p != place[0] && p != place[1] && p != place[2]) warn("vertex", element.properties[p].name);
    }
  }

  void warn(const std::string& element, const std::string& property) {
    file_.report.warnings.push_back("the " + element + " property '" + property.substr(0, 60) + "' is not kept");
  }

  void read_faces(const Element& element, Values& values) {
    constexpr std::size_t absent = ~std::size_t{0};
    std::size_t indices = absent;
    std::array<std::size_t, 4> channels{absent, absent, absent, absent};
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const Property& property = element.properties[p];
      static constexpr std::string_view names[] = {"red", "green", "blue", "alpha"};
      const auto channel = std::find(std::begin(names), std::end(names), property.name);
      if (property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index")) {
        indices = p;
      } else if (channel != std::end(names) && property.type == Type::uint8 && !property.count_type) {
        channels[static_cast<std::size_t>(channel - std::begin(names))] = p;
      } else {
        warn("face", property.name);
      }
    }
    if (indices == absent) fail_header("the faces have no vertex_indices");
    has_colors_ = channels[0] != absent && channels[1] != absent && channels[2] != absent;
    Mesh& mesh = file_.mesh;
    for (std::uint64_t f = 0; f < element.count; ++f) {
      if (f % 4096 == 0) context_.poll();
      Color color{200, 200, 200, 255};
      read_one(element, values, [&](std::size_t p, std::size_t, double value) {
        if (p == indices) {
          if (!(value >= 0) || value >= static_cast<double>(mesh.vertices.size()) || value != std::floor(value)) {
            values.fail("face " + std::to_string(f) + " names a vertex that is not there");
          }
          mesh.corners.push_back(static_cast<std::uint32_t>(value));
        }
        for (std::size_t k = 0; k < 4; ++k) {
          if (p != channels[k]) continue;
          if (!(value >= 0 && value <= 255)) values.fail("face " + std::to_string(f) + " has a colour beyond 255");
          (k == 0 ? color.r : k == 1 ? color.g : k == 2 ? color.b : color.a) = static_cast<std::uint8_t>(value);
        }
      });
      mesh.face_begin.push_back(mesh.corners.size());
      mesh.face_colors.push_back(color);
    }
  }

  void skip(const Element& element, Values& values) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (i % 4096 == 0) context_.poll();
      read_one(element, values, [](std::size_t, std::size_t, double) {});
    }
    file_.report.warnings.push_back("the elements '" + element.name.substr(0, 60) + "' are not kept");
  }

  std::string_view bytes_;
  std::string name_;
  const Context& context_;
  Header header_;
  MeshFile file_;
  bool has_colors_ = false;
};

}  // namespace

MeshFile read_ply(std::string_view bytes, const std::string& name, const Context& context) {
  return PlyReader(bytes, name, context).run();
}

}  // namespace quoin::io
