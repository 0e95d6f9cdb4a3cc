// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/exact_text.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <ostream>

#include "quoin/base/error.h"
#include "quoin/io/text_lines.h"

namespace quoin {

namespace {

// Names may hold anything; spaces, '#', '%' and control characters become %XX, so that a name is one word.
std::string encoded(const std::string& name) {
  static constexpr char digits[] = "0123456789ABCDEF";
  std::string word;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 0x20 && byte != 0x7F && c != '#' && c != '%') {
      word += c;
    } else {
      word += {'%', digits[byte >> 4], digits[byte & 15]};
    }
  }
  return word;
}

std::string decoded(std::string_view word) {
  std::string name;
  for (std::size_t i = 0; i < word.size(); ++i) {
    unsigned byte = 0;
    if (word[i] == '%' && i + 2 < word.size()) {
      const auto [end, error] = std::from_chars(word.data() + i + 1, word.data() + i + 3, byte, 16);
      if (error == std::errc() && end == word.data() + i + 3) {
        name += static_cast<char>(byte);
        i += 2;
        continue;
      }
    }
    name += word[i];
  }
  return name;
}

class ExactReader {
 public:
  ExactReader(std::string_view text, const std::string& name) : size_(text.size()), lines_(text, name, '#') {}

  Brep run() {
    expect("quoin-solid", 2);
    if (lines_.words()[1] != "1") lines_.fail("this version of the format is not known");
    brep_.is_unbounded = choice("unbounded", "no", "yes");
    read_names();
    read_shells();
    read_points();
    read_faces();
    if (lines_.next()) lines_.fail("nothing should follow 'end'");
    return std::move(brep_);
  }

 private:
  void expect_at_least(std::string_view keyword, std::size_t words) {
    lines_.need("'" + std::string(keyword) + "'");
    if (lines_.words()[0] != keyword) lines_.fail("'" + std::string(keyword) + "' should stand here");
    if (lines_.words().size() < words) lines_.fail("the line is too short");
  }

  void expect(std::string_view keyword, std::size_t words) {
    expect_at_least(keyword, words);
    expect_size(words);
  }

  void expect_size(std::size_t words) const {
    if (lines_.words().size() > words) lines_.fail(io::quoted(lines_.words()[words]) + " does not belong here");
  }

  // A line of the keyword and one of two words; whether it is the second.
  bool choice(std::string_view keyword, std::string_view first, std::string_view second) {
    expect(keyword, 2);
    const std::string_view word = lines_.words()[1];
    if (word != first && word != second)
      lines_.fail(io::quoted(word) + " is neither '" + std::string(first) + "' nor '" + std::string(second) + "'");
    return word == second;
  }

  std::size_t count(std::size_t word) const {
    const std::int64_t value = lines_.integer(lines_.words().at(word));
    if (value < 0 || static_cast<std::uint64_t>(value) > size_) lines_.fail("this count does not fit the file's size");
    return static_cast<std::size_t>(value);
  }

  std::uint32_t index(std::size_t word, std::size_t bound) const {
    if (word >= lines_.words().size()) lines_.fail("the line is too short");
    const std::int64_t value = lines_.integer(lines_.words()[word]);
    if (value < 0 || static_cast<std::uint64_t>(value) >= bound)
      lines_.fail("index " + std::to_string(value) + " is out of range");
    return static_cast<std::uint32_t>(value);
  }

  Rational rational(std::string_view word) const {
    try {
      return Rational::parse(word);
    } catch (const InputError& error) {
      lines_.fail(error.what());
    }
  }

  void read_names() {
    expect("inputs", 2);
    const std::size_t names = count(1);
    for (std::size_t i = 0; i < names; ++i) {
      expect_at_least("input", 1);
      expect_size(2);
      brep_.leaf_names.push_back(lines_.words().size() > 1 ? decoded(lines_.words()[1]) : "");
    }
  }

  void read_shells() {
    expect("components", 2);
    const std::size_t components = count(1);
    const std::size_t line = lines_.line();
    expect("shells", 2);
    const std::size_t shells = count(1);
    for (std::size_t i = 0; i < shells; ++i) {
      brep_.shells.push_back({choice("shell", "outer", "void")});
    }
    // Each piece of material has one outer shell; one that reaches infinity has none.
    const auto outer = std::ranges::count(brep_.shells, false, &Shell::is_void);
    brep_.component_count = static_cast<std::uint32_t>(outer) + (brep_.is_unbounded ? 1 : 0);
    if (components != brep_.component_count) {
      lines_.fail_at(line, std::to_string(components) + " components are declared, and the shells bound " +
                               std::to_string(brep_.component_count));
    }
  }

  void read_points() {
    expect("points", 2);
    const std::size_t points = count(1);
    std::vector<RationalPoint3> exact;
    for (std::size_t i = 0; i < points; ++i) {
      lines_.need("point " + std::to_string(i));
      if (lines_.words().size() != 3) lines_.fail("a point has three coordinates");
      exact.push_back({rational(lines_.words()[0]), rational(lines_.words()[1]), rational(lines_.words()[2])});
    }
    brep_.points = Constructions(std::move(exact));
  }

  void read_faces() {
    const bool has_colors = choice("colors", "no", "yes");
    expect("faces", 2);
    const std::size_t faces = count(1);
    const std::size_t points = brep_.points.point_count();
    for (std::size_t f = 0; f < faces; ++f) {
      expect_at_least("face", 7);
      brep_.face_shells.push_back(index(1, brep_.shells.size()));
      brep_.face_planes.push_back({PointId{index(2, points)}, PointId{index(3, points)}, PointId{index(4, points)}});
      const std::size_t loops = count(5);
      const std::size_t origins = count(6);
      if (loops == 0 || origins == 0) lines_.fail("a face has at least one loop and one origin");
      for (std::size_t o = 0; o < origins; ++o) {
        brep_.origins.push_back({index(7 + 2 * o, brep_.leaf_names.size()), index(8 + 2 * o, 0xFFFFFFFFU)});
      }
      brep_.face_first_origin.push_back(static_cast<std::uint32_t>(brep_.origins.size()));
      expect_size(7 + 2 * origins + (has_colors ? 4 : 0));
      if (has_colors) {
        const auto channel = [&](std::size_t k) { return static_cast<std::uint8_t>(index(7 + 2 * origins + k, 256)); };
        brep_.face_colors.push_back({channel(0), channel(1), channel(2), channel(3)});
      }
      for (std::size_t l = 0; l < loops; ++l) {
        expect_at_least("loop", 2);  // two vertices are an edge inside the face, one a vertex
        for (std::size_t i = 1; i < lines_.words().size(); ++i)
          brep_.loop_vertices.push_back(PointId{index(i, points)});
        brep_.loop_begin.push_back(static_cast<std::uint32_t>(brep_.loop_vertices.size()));
      }
      brep_.face_first_loop.push_back(static_cast<std::uint32_t>(brep_.loop_begin.size() - 1));
    }
    expect("end", 1);
  }

  std::size_t size_;
  io::TextLines lines_;
  Brep brep_;
};

}  // namespace

void write_exact_text(std::ostream& out, const Brep& b) {
  out << "quoin-solid 1\nunbounded " << (b.is_unbounded ? "yes" : "no") << "\ninputs " << b.leaf_names.size() << "\n";
  for (const std::string& name : b.leaf_names) out << "input " << encoded(name) << "\n";
  out << "components " << b.component_count << "\nshells " << b.shells.size() << "\n";
  for (const Shell& shell : b.shells) out << "shell " << (shell.is_void ? "void" : "outer") << "\n";
  out << "points " << b.points.point_count() << "\n";
  for (std::size_t i = 0; i < b.points.point_count(); ++i) {
    const RationalPoint3 p = b.points.exact(PointId{i});
    out << p.x.to_string() << " " << p.y.to_string() << " " << p.z.to_string() << "\n";
  }
  out << "colors " << (b.face_colors.empty() ? "no" : "yes") << "\n";
  out << "faces " << b.face_count() << "\n";
  for (std::size_t f = 0; f < b.face_count(); ++f) {
    const auto& plane = b.face_planes[f];
    out << "face " << b.face_shells[f] << " " << plane[0].value << " " << plane[1].value << " " << plane[2].value << " "
        << b.face_first_loop[f + 1] - b.face_first_loop[f] << " "
        << b.face_first_origin[f + 1] - b.face_first_origin[f];
    for (std::uint32_t o = b.face_first_origin[f]; o < b.face_first_origin[f + 1]; ++o) {
      out << " " << b.origins[o].leaf << " " << b.origins[o].face;
    }
    if (!b.face_colors.empty()) {
      const Color& c = b.face_colors[f];
      out << " " << int{c.r} << " " << int{c.g} << " " << int{c.b} << " " << int{c.a};
    }
    out << "\n";
    for (std::uint32_t l = b.face_first_loop[f]; l < b.face_first_loop[f + 1]; ++l) {
      out << "loop";
      for (const PointId p : b.loop(l)) out << " " << p.value;
      out << "\n";
    }
  }
  out << "end\n";
}

void write_exact_text(const std::filesystem::path& path, const Brep& boundary) {
  std::ofstream out(path, std::ios::binary);
  if (!out) throw FileError(path.string() + ": cannot be written");
  write_exact_text(out, boundary);
  out.close();
  if (!out) throw FileError(path.string() + ": writing failed");
}

Brep read_exact_text(std::string_view text, const std::string& name) {
  return ExactReader(text, name).run();
}

}  // namespace quoin
