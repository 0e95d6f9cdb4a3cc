// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "quoin/base/error.h"
#include "quoin/io/ply_layout.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

/// The values of a PLY file's body, one after the other, text or binary.
class PlyValues {
 public:
  PlyValues(std::string_view body, const PlyLayout& layout, std::string name)
      : body_(body), name_(std::move(name)), offset_(layout.size), line_(layout.lines), format_(layout.format) {}

  std::size_t remaining() const { return body_.size() - position_; }

  /// Perhaps not finite, in text as in binary.
  double next(PlyType type) { return format_ == MeshFormat::ply_text ? next_word() : next_binary(type); }

  /// Ends an element: in text, each has a line.
  void end_element() {
    if (format_ != MeshFormat::ply_text) return;
    position_ = std::min(body_.find_first_not_of(" \t\v\f", position_), body_.size());
    if (position_ < body_.size() && body_[position_] != '\n' && body_[position_] != '\r')
      fail("the line goes on behind the values of its element");
  }

  /// Of the last value, in text.
  std::size_t line() const { return line_ + 1; }

  /// The line or byte of the next value, or nothing where none is left.
  std::optional<std::string> place_of_next() {
    if (format_ == MeshFormat::ply_text) skip_space();
    if (remaining() == 0) return std::nullopt;
    return format_ == MeshFormat::ply_text ? "line " + std::to_string(line_ + 1)
                                           : "byte " + std::to_string(offset_ + position_);
  }

  /// @throws InputError  an element's count is larger than what is left has bytes
  void require_room(const PlyElement& element) const {
    if (element.count > remaining()) {
      fail("a count of " + std::to_string(element.count) + " " + element.name + " does not fit the file's size");
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    if (format_ == MeshFormat::ply_text) throw InputError(name_ + ":" + std::to_string(line()) + ": " + what);
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
    if (!parse_any_number(word, value)) fail(quoted(word) + " is not a number");
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

  double next_binary(PlyType type) {
    if (remaining() < size_of(type)) fail("the file ends within its elements");
    double value = 0;
    switch (type) {
      case PlyType::int8:
        value = decode<std::int8_t>();
        break;
      case PlyType::uint8:
        value = decode<std::uint8_t>();
        break;
      case PlyType::int16:
        value = decode<std::int16_t>();
        break;
      case PlyType::uint16:
        value = decode<std::uint16_t>();
        break;
      case PlyType::int32:
        value = decode<std::int32_t>();
        break;
      case PlyType::uint32:
        value = decode<std::uint32_t>();
        break;
      case PlyType::float32:
        value = decode<float>();
        break;
      case PlyType::float64:
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

/// Calls take(property index, position in its list, value) for every value of one element.
template <class Take>
void read_ply_element(const PlyElement& element, PlyValues& values, const Take& take) {
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    std::size_t length = 1;
    if (property.count_type) {
      const double announced = values.next(*property.count_type);
      if (announced < 0 || announced > static_cast<double>(values.remaining()) || announced != std::floor(announced)) {
        values.fail("a list of " + std::to_string(announced) + " values does not fit the file's size");
      }
      length = static_cast<std::size_t>(announced);
    }
    for (std::size_t i = 0; i < length; ++i) take(p, i, values.next(property.type));
  }
  values.end_element();
}

}  // namespace quoin::io
