// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/exact_text.h"

#include <algorithm>
#include <fstream>
#include <ostream>

#include "quoin/base/error.h"
#include "quoin/io/exact_lines.h"

namespace quoin {

namespace {

class ExactReader {
 public:
  ExactReader(std::string_view text, const std::string& name) : lines_(text, name) {}

  Brep run() {
    lines_.expect("quoin-solid", 2);
    if (lines_.words()[1] != "1") lines_.fail("this version of the format is not known");
    brep_.is_unbounded = lines_.choice("unbounded", "no", "yes");
    read_names();
    read_shells();
    read_points();
    read_faces();
    lines_.expect_end();
    return std::move(brep_);
  }

 private:
  void read_names() {
    lines_.expect("inputs", 2);
    const std::size_t names = lines_.count(1);
    for (std::size_t i = 0; i < names; ++i) {
      lines_.expect_at_least("input", 1);
      lines_.expect_size(2);
      brep_.leaf_names.push_back(lines_.words().size() > 1 ? io::decoded_name(lines_.words()[1]) : "");
    }
  }

  void read_shells() {
    lines_.expect("components", 2);
    const std::size_t components = lines_.count(1);
    const std::size_t line = lines_.line();
    lines_.expect("shells", 2);
    const std::size_t shells = lines_.count(1);
    for (std::size_t i = 0; i < shells; ++i) {
      brep_.shells.push_back({lines_.choice("shell", "outer", "void")});
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
    lines_.expect("points", 2);
    const std::size_t points = lines_.count(1);
    std::vector<RationalPoint3> exact;
    for (std::size_t i = 0; i < points; ++i) {
      lines_.need("point " + std::to_string(i));
      if (lines_.words().size() != 3) lines_.fail("a point has three coordinates");
      exact.push_back(
          {lines_.rational(lines_.words()[0]), lines_.rational(lines_.words()[1]), lines_.rational(lines_.words()[2])});
    }
    brep_.points = Constructions(std::move(exact));
  }

  void read_faces() {
    const bool has_colors = lines_.choice("colors", "no", "yes");
    lines_.expect("faces", 2);
    const std::size_t faces = lines_.count(1);
    const std::size_t points = brep_.points.point_count();
    for (std::size_t f = 0; f < faces; ++f) {
      lines_.expect_at_least("face", 7);
      brep_.face_shells.push_back(lines_.index(1, brep_.shells.size()));
      brep_.face_planes.push_back(
          {PointId{lines_.index(2, points)}, PointId{lines_.index(3, points)}, PointId{lines_.index(4, points)}});
      const std::size_t loops = lines_.count(5);
      const std::size_t origins = lines_.count(6);
      if (loops == 0 || origins == 0) lines_.fail("a face has at least one loop and one origin");
      for (std::size_t o = 0; o < origins; ++o) {
        brep_.origins.push_back(
            {lines_.index(7 + 2 * o, brep_.leaf_names.size()), lines_.index(8 + 2 * o, 0xFFFFFFFFU)});
      }
      brep_.face_first_origin.push_back(static_cast<std::uint32_t>(brep_.origins.size()));
      lines_.expect_size(7 + 2 * origins + (has_colors ? 4 : 0));
      if (has_colors) {
        const auto channel = [&](std::size_t k) {
          return static_cast<std::uint8_t>(lines_.index(7 + 2 * origins + k, 256));
        };
        brep_.face_colors.push_back({channel(0), channel(1), channel(2), channel(3)});
      }
      for (std::size_t l = 0; l < loops; ++l) {
        lines_.expect_at_least("loop", 2);  // two vertices are an edge inside the face, one a vertex
        for (std::size_t i = 1; i < lines_.words().size(); ++i)
          brep_.loop_vertices.push_back(PointId{lines_.index(i, points)});
        brep_.loop_begin.push_back(static_cast<std::uint32_t>(brep_.loop_vertices.size()));
      }
      brep_.face_first_loop.push_back(static_cast<std::uint32_t>(brep_.loop_begin.size() - 1));
    }
  }

  io::ExactLines lines_;
  Brep brep_;
};

}  // namespace

void write_exact_text(std::ostream& out, const Brep& b) {
  out << "quoin-solid 1\nunbounded " << (b.is_unbounded ? "yes" : "no") << "\ninputs " << b.leaf_names.size() << "\n";
  for (const std::string& name : b.leaf_names) out << "input " << io::encoded_name(name) << "\n";
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
