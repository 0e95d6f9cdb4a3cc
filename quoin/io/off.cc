// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "quoin/io/readers.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

class OffReader {
 public:
  OffReader(std::string_view bytes, const std::string& name, const Context& context)
      : size_(bytes.size()), lines_(bytes, name, '#'), context_(context) {
    file_.report.format = MeshFormat::off;
  }

  MeshFile run() {
    read_header();
    Mesh& mesh = file_.mesh;
    mesh.vertices.reserve(vertex_count_);
    for (std::size_t i = 0; i < vertex_count_; ++i) read_vertex(i);
    mesh.face_begin.reserve(face_count_ + 1);
    for (std::size_t f = 0; f < face_count_; ++f) read_face(f);
    if (lines_.next()) {
      file_.report.warnings.push_back("line " + std::to_string(lines_.line()) +
                                      ": what follows the last face is not kept");
    }
    if (!has_colors_) mesh.face_colors.clear();
    if (has_extra_) file_.report.warnings.push_back("what the vertex lines hold beyond x, y, z is not kept");
    if (has_color_indices_) file_.report.warnings.push_back("colours given as an index into a map are not kept");
    return std::move(file_);
  }

 private:
  void read_header() {
    lines_.need("OFF and the counts");
    std::vector<std::string_view> counts = lines_.words();
    const std::string_view first = counts[0];
    if (first.ends_with("OFF")) {
      const std::string_view kind = first.substr(0, first.size() - 3);
      if (kind.find_first_not_of("STCN") != std::string_view::npos) {
        lines_.fail("'" + std::string(first.substr(0, 20)) + "' is not a kind of OFF with three coordinates");
      }
      counts.erase(counts.begin());
      if (!counts.empty() && counts[0] == "BINARY") lines_.fail("binary OFF is not read");
      if (counts.empty()) {
        lines_.need("the counts of vertices, faces and edges");
        counts = lines_.words();
      }
    }
    if (counts.size() < 2) lines_.fail("the counts of vertices and faces should stand here");
    vertex_count_ = count(counts[0]);
    face_count_ = count(counts[1]);
  }

  std::size_t count(std::string_view word) const {
    const std::int64_t value = lines_.integer(word);
    if (value < 0 || static_cast<std::uint64_t>(value) > size_) {
      lines_.fail("a count of " + std::string(word.substr(0, 30)) + " does not fit the file's size");
    }
    return static_cast<std::size_t>(value);
  }

  void read_vertex(std::size_t i) {
    if (i % 4096 == 0) context_.poll();
    lines_.need("vertex " + std::to_string(i));
    const auto& words = lines_.words();
    if (words.size() < 3) lines_.fail("vertex " + std::to_string(i) + " has fewer than three coordinates");
    for (std::size_t k = 3; k < words.size(); ++k) lines_.number(words[k]);
    has_extra_ = has_extra_ || words.size() > 3;
    file_.mesh.vertices.push_back({lines_.number(words[0]), lines_.number(words[1]), lines_.number(words[2])});
  }

  void read_face(std::size_t f) {
    if (f % 4096 == 0) context_.poll();
    lines_.need("face " + std::to_string(f));
    const auto& words = lines_.words();
    const std::int64_t corners = lines_.integer(words[0]);
    if (corners < 1 || static_cast<std::uint64_t>(corners) > words.size() - 1) {
      lines_.fail("face " + std::to_string(f) + " names " + std::to_string(words.size() - 1) + " of " +
                  std::to_string(corners) + " corners");
    }
    Mesh& mesh = file_.mesh;
    for (std::int64_t k = 1; k <= corners; ++k) {
      const std::int64_t v = lines_.integer(words[static_cast<std::size_t>(k)]);
      if (v < 0 || static_cast<std::uint64_t>(v) >= mesh.vertices.size()) {
        lines_.fail("face " + std::to_string(f) + ": vertex " + std::to_string(v) + " is not there");
      }
      mesh.corners.push_back(static_cast<std::uint32_t>(v));
    }
    mesh.face_begin.push_back(mesh.corners.size());
    read_color(std::vector<std::string_view>(words.begin() + 1 + corners, words.end()));
  }

  // Three or four numbers: integers up to 255, or fractions up to 1.
  void read_color(const std::vector<std::string_view>& words) {
    Color color{200, 200, 200, 255};
    if (words.size() >= 3) {
      const bool fractions = std::any_of(words.begin(), words.end(),
                                         [](std::string_view w) { return w.find('.') != std::string_view::npos; });
      const auto channel = [&](std::size_t k) {
        const double value = lines_.number(words[k]) * (fractions ? 255 : 1);
        return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
      };
      color = {channel(0), channel(1), channel(2), words.size() > 3 ? channel(3) : std::uint8_t{255}};
      has_colors_ = true;
    } else if (!words.empty()) {
      for (const std::string_view word : words) lines_.number(word);
      has_color_indices_ = true;
    }
    if (words.size() > 4) lines_.fail("the line goes on behind a colour");
    file_.mesh.face_colors.push_back(color);
  }

  std::size_t size_;
  TextLines lines_;
  const Context& context_;
  MeshFile file_;
  std::size_t vertex_count_ = 0;
  std::size_t face_count_ = 0;
  bool has_colors_ = false;
  bool has_extra_ = false;
  bool has_color_indices_ = false;
};

}  // namespace

MeshFile read_off(std::string_view bytes, const std::string& name, const Context& context) {
  return OffReader(bytes, name, context).run();
}

}  // namespace quoin::io
