// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/sphere_curves.h"

#include <array>

#include "quoin/io/text_lines.h"

namespace quoin {

namespace {

Rational exact_number(const io::TextLines& lines, std::string_view word) {
  if (word.find('/') == std::string_view::npos) return Rational(lines.number(word));
  try {
    return Rational::parse(word);
  } catch (const InputError&) {
    lines.fail(io::quoted(word) + " is no number");
  }
}

SphereDirection direction(const io::TextLines& lines, std::size_t first) {
  const auto& words = lines.words();
  return SphereDirection(std::array<Rational, 3>{
      exact_number(lines, words[first]), exact_number(lines, words[first + 1]), exact_number(lines, words[first + 2])});
}

void add_curve(const io::TextLines& lines, GeodesicFamily& family, PieceList<GeodesicFamily>& list) {
  const auto& words = lines.words();
  const auto is = [&](std::string_view word, std::size_t numbers) {
    return io::is_word(words[0], word) && words.size() == numbers + 1;
  };
  if (is("arc", 6)) {
    family.add_arc(list, direction(lines, 1), direction(lines, 4));
  } else if (is("arc", 9)) {
    family.add_arc(list, direction(lines, 1), direction(lines, 4), direction(lines, 7));
  } else if (is("circle", 3)) {
    family.add_great_circle(list, direction(lines, 1));
  } else if (is("point", 3)) {
    family.add_point(list, direction(lines, 1));
  } else {
    lines.fail("expected arc with 6 or 9 numbers, or circle or point with 3, got " + io::quoted(words[0]) + " with " +
               std::to_string(words.size() - 1));
  }
}

}  // namespace

void read_sphere_curves(std::string_view text, const std::string& name, GeodesicFamily& family,
                        PieceList<GeodesicFamily>& list, std::vector<std::string>& names) {
  io::TextLines lines(text, name, '#');
  while (lines.next()) {
    const std::size_t curves = list.curve_count;
    try {
      add_curve(lines, family, list);
    } catch (const InputError& error) {
      const std::string what = error.what();
      if (what.starts_with(name)) throw;
      lines.fail(what);
    }
    for (std::size_t i = curves; i < list.curve_count; ++i) {
      names.push_back(std::string(lines.words()[0]) + " in line " + std::to_string(lines.line()));
    }
  }
}

}  // namespace quoin
