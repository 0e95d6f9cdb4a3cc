// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/page.h"

#include <algorithm>
#include <limits>

#include "quoin/base/error.h"
#include "quoin/view/base64.h"
#include "quoin/view/built_templates.h"
#include "quoin/view/page_format.h"
#include "quoin/view/page_text.h"
#include "quoin/view/scene_check.h"
#include "quoin/view/scene_frame.h"

namespace quoin {

bool has_view() {
  return !built_page_template().empty();
}

namespace {

enum class ElementType { u8, u16, u32, f32, f64 };

constexpr std::string_view name_of(ElementType type) {
  constexpr std::array<std::string_view, 5> names{"u8", "u16", "u32", "f32", "f64"};
  return names[static_cast<std::size_t>(type)];
}

SceneFrame frame_of(const ViewScene& scene) {
  SceneBounds bounds;
  for (const ViewPart& part : scene.parts) {
    for (const Point3& p : part.vertices) bounds.include(p);
  }
  return bounds.frame();
}

bool floats_hold_planes(const std::vector<ViewFace>& faces) {
  return std::ranges::all_of(faces, [](const ViewFace& face) {
    return std::ranges::all_of(face.plane, [](double c) { return double{static_cast<float>(c)} == c; });
  });
}

bool has_no_plane(const ViewFace& face) {
  return std::ranges::all_of(face.plane, [](double c) { return c == 0; });
}

/// Calls `visit(key, type, length, at)` for every array of the part that is not all zero, always in the same order.
template <class Visit>
class PartArrays {
 public:
  PartArrays(const ViewPart& part, const SceneFrame& frame, Visit& visit) : part_(part), frame_(frame), visit_(visit) {}

  void visit_all() {
    visit_geometry();
    visit_faces();
    visit_colors();
    visit_texts();
  }

 private:
  template <class At>
  void unsigned_array(std::string_view key, std::size_t length, const At& at, bool omit_zeros = false) {
    std::uint32_t largest = 0;
    for (std::size_t i = 0; i < length; ++i) largest = std::max(largest, at(i));
    if (length == 0 || (omit_zeros && largest == 0)) return;
    visit_(key,
           largest < 1U << 8    ? ElementType::u8
           : largest < 1U << 16 ? ElementType::u16
                                : ElementType::u32,
           length, at);
  }

  template <class At>
  void real_array(std::string_view key, ElementType type, std::size_t length, const At& at) {
    if (length > 0) visit_(key, type, length, at);
  }

  void visit_geometry() {
    const auto& vertices = part_.vertices;
    if (frame_.floats_hold(vertices)) {
      real_array("vertices", ElementType::f32, 3 * vertices.size(),
                 [&](std::size_t i) { return double{frame_.relative(vertices[i / 3][i % 3], i % 3)}; });
    } else {
      real_array("vertices", ElementType::f64, 3 * vertices.size(),
                 [&](std::size_t i) { return vertices[i / 3][i % 3]; });
    }
    unsigned_array("triangles", 3 * part_.triangles.size(),
                   [&](std::size_t i) { return part_.triangles[i / 3][i % 3]; });
    unsigned_array("triangleFaces", part_.triangle_face.size(), [&](std::size_t i) { return part_.triangle_face[i]; });
    unsigned_array("edges", 2 * part_.edges.size(), [&](std::size_t i) { return part_.edges[i / 2][i % 2]; });
  }

  void visit_faces() {
    const auto& faces = part_.faces;
    if (!std::ranges::all_of(faces, has_no_plane)) {
      real_array("planes", floats_hold_planes(faces) ? ElementType::f32 : ElementType::f64, 4 * faces.size(),
                 [&](std::size_t i) { return faces[i / 4].plane[i % 4]; });
    }
    unsigned_array("faceSpans", 3 * part_.face_spans.size(),
                   [&](std::size_t i) { return part_.face_spans[i / 3][i % 3]; });
    real_array("planePoints", ElementType::f64, 3 * part_.plane_points.size(),
               [&](std::size_t i) { return part_.plane_points[i / 3][i % 3]; });
    unsigned_array(
        "faceOrigins", faces.size(), [&](std::size_t i) { return faces[i].origin; }, true);
    unsigned_array(
        "faceOriginFaces", faces.size(), [&](std::size_t i) { return faces[i].origin_face; }, true);
    unsigned_array(
        "facePieces", faces.size(), [&](std::size_t i) { return faces[i].piece; }, true);
    unsigned_array("moreOrigins", 3 * part_.more_origins.size(), [&](std::size_t i) {
      const ViewOrigin& more = part_.more_origins[i / 3];
      return i % 3 == 0 ? more.face : i % 3 == 1 ? more.origin : more.origin_face;
    });
  }

  void visit_colors() {
    const auto& faces = part_.faces;
    const auto is_colored = [&](std::size_t i) { return std::uint32_t{faces[i].color.has_value()}; };
    if (std::ranges::none_of(faces, [](const ViewFace& face) { return face.color.has_value(); })) return;
    unsigned_array("colors", 4 * faces.size(), [&](std::size_t i) -> std::uint32_t {
      const Color color = faces[i / 4].color.value_or(Color{});
      return i % 4 == 0 ? color.r : i % 4 == 1 ? color.g : i % 4 == 2 ? color.b : color.a;
    });
    unsigned_array("colored", faces.size(), is_colored);
  }

  void visit_texts() {
    const auto& texts = part_.plane_texts;
    std::size_t face = 0;
    std::size_t begin = 0;
    std::size_t total = 0;
    for (const std::string& text : texts) total += text.size();
    if (total == 0) return;
    if (total > std::numeric_limits<std::uint32_t>::max()) throw InputError("view: the texts of planes exceed 4 GB");
    const auto byte_at = [&](std::size_t i) -> std::uint32_t {
      if (i == 0) face = begin = 0;
      while (i - begin >= texts[face].size()) begin += texts[face++].size();
      return static_cast<std::uint8_t>(texts[face][i - begin]);
    };
    visit_("planeTexts", ElementType::u8, total, byte_at);
    std::uint32_t end = 0;
    visit_("planeTextEnds", ElementType::u32, texts.size(), [&](std::size_t i) {
      end = (i == 0 ? 0 : end) + static_cast<std::uint32_t>(texts[i].size());
      return end;
    });
  }

  const ViewPart& part_;
  const SceneFrame& frame_;
  Visit& visit_;
};

template <class Visit>
void visit_arrays(const ViewPart& part, const SceneFrame& frame, Visit visit) {
  PartArrays<Visit>(part, frame, visit).visit_all();
}

class PageWriter {
 public:
  PageWriter(std::ostream& out, const ViewScene& scene) : out_(out), scene_(scene), frame_(frame_of(scene)) {}

  void write_scene() {
    out_ << "<script type=\"application/json\" id=\"quoin-scene\">";
    write_header();
    out_ << "</script>\n";
    for (const ViewPart& part : scene_.parts) write_blocks(part);
  }

 private:
  void write_header() {
    out_ << "{\"format\":\"quoin-scene\",\"version\":";
    write_number(page_format::version);
    out_ << ",\"title\":";
    write_string(scene_.title);
    out_ << ",\"unit\":";
    write_string(scene_.unit);
    out_ << ",\"facts\":";
    write_facts(scene_.facts);
    out_ << ",\"center\":[";
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis > 0) out_ << ',';
      write_number(frame_.center[axis]);
    }
    out_ << "],\"scale\":";
    write_number(frame_.scale);
    out_ << ",\"origins\":";
    write_list(scene_.origins, [&](const std::string& name) { write_string(name); });
    out_ << ",\"parts\":";
    write_list(scene_.parts, [&](const ViewPart& part) { write_part_header(part); });
    out_ << '}';
  }

  void write_part_header(const ViewPart& part) {
    out_ << "\n{\"name\":";
    write_string(part.name);
    out_ << ",\"facts\":";
    write_facts(part.facts);
    out_ << ",\"faceCount\":";
    write_number(part.faces.size());
    out_ << ",\"arrays\":{";
    const char* separator = "";
    visit_arrays(part, frame_, [&](std::string_view key, ElementType type, std::size_t length, const auto&) {
      out_ << separator << '"' << key << "\":{\"type\":\"" << name_of(type) << "\",\"length\":";
      write_number(length);
      out_ << ",\"block\":";
      write_number(header_blocks_++);
      out_ << '}';
      separator = ",";
    });
    out_ << "}}";
  }

  void write_blocks(const ViewPart& part) {
    visit_arrays(part, frame_, [&](std::string_view, ElementType type, std::size_t length, const auto& at) {
      out_ << "<script type=\"text/plain\" id=\"quoin-block-";
      write_number(blocks_++);
      out_ << "\">";
      Base64Writer block(out_);
      for (std::size_t i = 0; i < length; ++i) put(block, type, at(i));
      block.finish();
      out_ << "</script>\n";
    });
  }

  template <class Value>
  static void put(Base64Writer& block, ElementType type, Value value) {
    switch (type) {
      case ElementType::u8:
        return block.put(static_cast<std::uint8_t>(value));
      case ElementType::u16:
        return block.put(static_cast<std::uint16_t>(value));
      case ElementType::u32:
        return block.put(static_cast<std::uint32_t>(value));
      case ElementType::f32:
        return block.put(static_cast<float>(value));
      case ElementType::f64:
        return block.put(static_cast<double>(value));
    }
  }

  template <class List, class Write>
  void write_list(const List& list, const Write& write) {
    page_text::write_json_list(out_, list, write);
  }
  void write_facts(const std::vector<ViewFact>& facts) { page_text::write_json_facts(out_, facts); }
  void write_string(std::string_view text) { page_text::write_json_string(out_, text); }
  template <class Number>
  void write_number(Number value) {
    page_text::write_number(out_, value);
  }

  std::ostream& out_;
  const ViewScene& scene_;
  SceneFrame frame_;
  std::size_t header_blocks_ = 0;
  std::size_t blocks_ = 0;
};

}  // namespace

void write_page(std::ostream& out, const ViewScene& scene) {
  if (!has_view()) throw Error("the browser view was not built into this quoin (configure with -DQUOIN_VIEW=ON)");
  write_page(out, scene, built_page_template());
}

void write_page(std::ostream& out, const ViewScene& scene, std::string_view page_template) {
  const page_text::Template page = page_text::split_template(page_template);
  check_scene(scene);
  PageWriter writer(out, scene);
  out << page.before_title;
  page_text::write_title(out, scene.title);
  out << page.before_scene;
  writer.write_scene();
  out << page.rest;
}

}  // namespace quoin
