// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

/// Inputs of the benchmarks of arrangements: text files of one line `KIND COUNT`, then COUNT lines of decimal integers,
///
///   segments n        x1 y1 x2 y2
///   circles n         cx cy r
///   great_circles n   nx ny nz                 normal of the plane of the circle
///   geodesics n       ax ay az bx by bz        the arc shorter than pi between two directions
///   polygons n        m x1 y1 ... xm ym        simple, counterclockwise
///   points n          x y
///
/// Written by make_arrangement_inputs; read by the program that measures Quoin and by its peers.
namespace arrangement_input {

struct Input {
  std::string kind;                   ///< the first word of the file
  std::vector<std::int64_t> numbers;  ///< of all elements, without the counts of vertices of polygons
  std::vector<std::size_t> starts;    ///< where each element starts in `numbers`, and the end

  std::size_t size() const { return starts.size() - 1; }
  std::span<const std::int64_t> operator[](std::size_t i) const {
    return std::span(numbers).subspan(starts[i], starts[i + 1] - starts[i]);
  }
};

/// Integers one after the other from a text.
class Integers {
 public:
  Integers(const char* at, const char* end) : at_(at), end_(end) {}
  std::int64_t next() {
    while (at_ != end_ && std::isspace(static_cast<unsigned char>(*at_)) != 0) ++at_;
    std::int64_t value = 0;
    const auto [rest, error] = std::from_chars(at_, end_, value);
    if (error != std::errc()) throw std::runtime_error("an integer is missing");
    at_ = rest;
    return value;
  }

 private:
  const char* at_;
  const char* end_;
};

/// How many integers an element of a kind has; 0 for polygons, which say it themselves.
inline std::size_t width_of(const std::string& kind) {
  struct Width {
    const char* kind;
    std::size_t width;
  };
  constexpr std::array<Width, 6> widths{
      {{"segments", 4}, {"circles", 3}, {"great_circles", 3}, {"geodesics", 6}, {"polygons", 0}, {"points", 2}}};
  for (const Width& entry : widths) {
    if (kind == entry.kind) return entry.width;
  }
  throw std::runtime_error("unknown kind of input: " + kind);
}

/// @throws std::runtime_error  the file is missing or not of the form above
inline Input read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Input input;
  input.kind = text.substr(0, text.find(' '));
  const std::size_t width = width_of(input.kind);
  Integers integers(text.data() + input.kind.size(), text.data() + text.size());
  const auto count = static_cast<std::size_t>(integers.next());
  input.starts.push_back(0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t n = width != 0 ? width : 2 * static_cast<std::size_t>(integers.next());
    for (std::size_t k = 0; k < n; ++k) input.numbers.push_back(integers.next());
    input.starts.push_back(input.numbers.size());
  }
  return input;
}

}  // namespace arrangement_input
