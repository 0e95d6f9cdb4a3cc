// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <map>

#include "quoin/io/readers.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

bool is_obj_statement(std::string_view keyword) {
  static constexpr std::string_view known[] = {
      "bevel", "bsp",      "bzp",       "c_interp", "call",   "cdc",    "cdp",  "con",        "csh",
      "ctech", "d_interp", "deg",       "end",      "g",      "hole",   "l",    "lod",        "maplib",
      "mg",    "mtllib",   "o",         "p",        "res",    "s",      "scrv", "shadow_obj", "sp",
      "stech", "step",     "trace_obj", "trim",     "usemap", "usemtl", "vn",   "vp",         "vt"};
  static_assert(std::is_sorted(std::begin(known), std::end(known)));
  return std::binary_search(std::begin(known), std::end(known), keyword);
}

namespace {

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const std::string& name, const Context& context)
      : lines_(bytes, name, '#'), context_(context) {
    lines_.join_continued_lines();
    file_.report.format = MeshFormat::obj;
  }

  MeshFile run() {
    while (lines_.next()) {
      if (++statements_ % 4096 == 0) context_.poll();
      const std::string_view keyword = lines_.words()[0];
      if (keyword == "v") {
        read_vertex();
      } else if (keyword == "f" || keyword == "fo") {
        read_face();
      } else if (keyword == "o" && file_.mesh.name.empty() && lines_.words().size() > 1) {
        file_.mesh.name = lines_.words()[1];
        begin_group();
      } else {
        if (keyword == "o" || keyword == "g") begin_group();
        skip(keyword);
      }
    }
    for (const auto& [keyword, count] : skipped_) {
      file_.report.warnings.push_back("'" + keyword + "' statements are not kept: " + std::to_string(count));
    }
    return std::move(file_);
  }

 private:
  void skip(std::string_view keyword) {
    for (const std::string_view free_form : {"curv", "curv2", "surf", "cstype", "parm", "bmat"}) {
      if (keyword == free_form) lines_.fail("free-form curves and surfaces are not read");
    }
    if (!is_obj_statement(keyword)) lines_.fail(quoted(keyword) + " is no statement of an OBJ file");
    ++skipped_[std::string(keyword)];
  }

  /// A new object begins without a group.
  void begin_group() {
    const auto& words = lines_.words();
    std::string name;
    for (std::size_t k = 1; k < words.size(); ++k) name += (k > 1 ? " " : "") + std::string(words[k]);
    const bool is_object = words[0] == "o";
    const std::string object = file_.groups.empty() ? std::string() : file_.groups.back().object;
    file_.groups.push_back({is_object ? name : object, is_object ? std::string() : name, file_.mesh.face_count()});
  }

  void read_vertex() {
    const auto& words = lines_.words();
    if (words.size() < 4) lines_.fail("a vertex has fewer than three coordinates");
    // x y z, and perhaps a weight, or a colour of three or four numbers.
    if (words.size() == 6 || words.size() > 8)
      lines_.fail("a vertex of " + std::to_string(words.size() - 1) + " words");
    for (std::size_t k = 4; k < words.size(); ++k) {
      const double value = lines_.number(words[k]);
      if (words.size() == 5 && value != 1) ++skipped_["v with weight"];
    }
    if (words.size() > 5) ++skipped_["v with colour"];
    file_.mesh.vertices.push_back({lines_.number(words[1]), lines_.number(words[2]), lines_.number(words[3])});
  }

  void read_face() {
    const auto& words = lines_.words();
    if (words.size() < 2) lines_.fail("a face without corners");
    Mesh& mesh = file_.mesh;
    for (std::size_t k = 1; k < words.size(); ++k) {
      std::int64_t v = lines_.integer(words[k].substr(0, words[k].find('/')));
      const auto count = static_cast<std::int64_t>(mesh.vertices.size());
      v = v < 0 ? count + v : v - 1;
      if (v < 0 || v >= count) lines_.fail("vertex " + std::string(words[k].substr(0, 30)) + " is not there");
      mesh.corners.push_back(static_cast<std::uint32_t>(v));
    }
    mesh.face_begin.push_back(mesh.corners.size());
  }

  TextLines lines_;
  const Context& context_;
  MeshFile file_;
  std::size_t statements_ = 0;
  std::map<std::string, std::size_t> skipped_;
};

}  // namespace

MeshFile read_obj(std::string_view bytes, const std::string& name, const Context& context) {
  return ObjReader(bytes, name, context).run();
}

}  // namespace quoin::io
