// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/layered_page.h"

#include <algorithm>

#include "quoin/base/error.h"
#include "quoin/view/base64.h"
#include "quoin/view/built_templates.h"
#include "quoin/view/layer_layout.h"
#include "quoin/view/page.h"
#include "quoin/view/page_text.h"
#include "quoin/view/scene_frame.h"

// A page holds, for web/src/layers/layered_data.ts, which reads it:
//
//   <script type="application/json" id="quoin-layers">HEADER</script>
//   <script type="text/plain" id="quoin-block-0">BASE64</script> ...
//
// Arrays stand in HEADER as {type, length, block}: elements of that type (u8, u16, u32, f32, f64), little-endian, in
// base64. Points are f64, or f32: those of center + scale * value, which then is exact; near points are f32. A layer
// has vertices, and where they are not all alike `shown` (how many elements have begun, by value), `ends` (of those for
// ever the number of values), `colors` (red, green, blue, opacity) and `owners`.

namespace quoin {

namespace {

using page_text::write_json_list;
using page_text::write_json_string;
using page_text::write_number;

/// Bytes of each of these numbers.
int width_of(const std::vector<std::uint32_t>& numbers) {
  const std::uint32_t largest = numbers.empty() ? 0 : *std::ranges::max_element(numbers);
  return largest < 1U << 8 ? 1 : largest < 1U << 16 ? 2 : 4;
}

class LayeredPage {
 public:
  LayeredPage(std::ostream& out, const LayeredScene& scene) : out_(out), scene_(scene) {
    SceneBounds bounds;
    for (const auto* points : {&scene.points, &scene.near_points}) {
      for (const Point3& p : *points) bounds.include(p);
    }
    frame_ = bounds.frame();
    is_single_ = frame_.floats_hold(scene.points);
    for (const SceneLayer& layer : scene.layers) layers_.push_back(lay_out(layer, scene.values.size()));
  }

  void write() {
    out_ << "<script type=\"application/json\" id=\"quoin-layers\">";
    write_header();
    out_ << "</script>\n";
    write_points();
    write_near_points();
    write_unsigned(scene_.point_numbers);
    block(scene_.values.size(), [&](Base64Writer& b, std::size_t i) { b.put(scene_.values[i]); });
    write_pairs();
    if (pairs_have_points()) write_unsigned(pair_points());
    if (!scene_.links.empty()) write_links();
    for (const SceneCounts& counts : scene_.counts) {
      for (const SceneCount& row : counts.rows) write_unsigned(row.at);
    }
    for (const LaidOut& layer : layers_) {
      write_unsigned(layer.vertices);
      for (const auto* numbers : {&layer.shown, &layer.ends, &layer.colors, &layer.owners}) {
        if (!numbers->empty()) write_unsigned(*numbers);
      }
    }
  }

 private:
  void key(std::string_view name) { out_ << ",\"" << name << "\":"; }

  // Announces the next block.
  void array(std::string_view name, std::string_view type, std::size_t length) {
    key(name);
    out_ << "{\"type\":\"" << type << "\",\"length\":";
    write_number(out_, length);
    out_ << ",\"block\":";
    write_number(out_, announced_++);
    out_ << '}';
  }

  void array(std::string_view name, const std::vector<std::uint32_t>& numbers) {
    static constexpr std::array<std::string_view, 5> types{"", "u8", "u16", "", "u32"};
    array(name, types[static_cast<std::size_t>(width_of(numbers))], numbers.size());
  }

  void optional_array(std::string_view name, const std::vector<std::uint32_t>& numbers) {
    if (!numbers.empty()) array(name, numbers);
  }

  void write_header() {
    out_ << "{\"format\":\"quoin-layers\",\"version\":1,\"title\":";
    write_json_string(out_, scene_.title);
    key("facts");
    page_text::write_json_facts(out_, scene_.facts);
    key("center");
    write_json_list(out_, std::array{frame_.center.x, frame_.center.y, frame_.center.z},
                    [&](double c) { write_number(out_, c); });
    key("scale");
    write_number(out_, frame_.scale);
    key("valueName");
    write_json_string(out_, scene_.value_name);
    key("rootName");
    write_json_string(out_, scene_.root_name);
    if (scene_.value) {
      key("value");
      write_number(out_, *scene_.value);
    }
    key("pairsLeftOut");
    write_number(out_, scene_.pairs_left_out);
    key("hasAllValues");
    out_ << (scene_.has_all_values ? "true" : "false");
    array("points", is_single_ ? "f32" : "f64", 3 * scene_.points.size());
    if (!scene_.near_points.empty()) array("nearPoints", "f32", 3 * scene_.near_points.size());
    array("pointNumbers", scene_.point_numbers);
    array("values", "f64", scene_.values.size());
    array("pairs", "u32", 3 * scene_.pairs.size());
    if (pairs_have_points()) array("pairPoints", pair_points());
    if (!scene_.links.empty()) array("links", "u32", 2 * scene_.links.size());
    key("counts");
    write_json_list(out_, scene_.counts, [&](const SceneCounts& counts) { write_counts(counts); });
    key("layers");
    std::size_t next = 0;
    write_json_list(out_, scene_.layers, [&](const SceneLayer& layer) { write_layer_header(layer, layers_[next++]); });
    out_ << '}';
  }

  void write_counts(const SceneCounts& counts) {
    out_ << "{\"name\":";
    write_json_string(out_, counts.name);
    key("rows");
    write_json_list(out_, counts.rows, [&](const SceneCount& row) {
      out_ << "{\"name\":";
      write_json_string(out_, row.name);
      array("at", row.at);
      out_ << '}';
    });
    out_ << '}';
  }

  void write_layer_header(const SceneLayer& layer, const LaidOut& arrays) {
    static constexpr std::array kinds{"points", "segments", "triangles"};
    out_ << "\n{\"name\":";
    write_json_string(out_, layer.name);
    key("kind");
    write_json_string(out_, kinds[static_cast<std::size_t>(layer.kind)]);
    key("color");
    write_json_list(out_, std::array<int, 4>{layer.color.r, layer.color.g, layer.color.b, layer.color.a},
                    [&](int c) { write_number(out_, c); });
    key("size");
    write_number(out_, layer.size);
    key("elementName");
    write_json_string(out_, layer.element_name);
    key("isShown");
    out_ << (layer.is_shown ? "true" : "false");
    array("vertices", arrays.vertices);
    optional_array("shown", arrays.shown);
    optional_array("ends", arrays.ends);
    optional_array("colors", arrays.colors);
    optional_array("owners", arrays.owners);
    out_ << '}';
  }

  template <class Put>
  void block(std::size_t length, const Put& put) {
    out_ << "<script type=\"text/plain\" id=\"quoin-block-";
    write_number(out_, blocks_++);
    out_ << "\">";
    Base64Writer writer(out_);
    for (std::size_t i = 0; i < length; ++i) put(writer, i);
    writer.finish();
    out_ << "</script>\n";
  }

  void write_unsigned(const std::vector<std::uint32_t>& numbers) {
    const int width = width_of(numbers);
    block(numbers.size(), [&](Base64Writer& b, std::size_t i) {
      if (width == 1) {
        b.put(static_cast<std::uint8_t>(numbers[i]));
      } else if (width == 2) {
        b.put(static_cast<std::uint16_t>(numbers[i]));
      } else {
        b.put(numbers[i]);
      }
    });
  }

  void write_points() {
    block(scene_.points.size(), [&](Base64Writer& b, std::size_t i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = scene_.points[i][axis];
        is_single_ ? b.put(frame_.relative(x, axis)) : b.put(x);
      }
    });
  }

  void write_near_points() {
    if (scene_.near_points.empty()) return;
    block(scene_.near_points.size(), [&](Base64Writer& b, std::size_t i) {
      for (std::size_t axis = 0; axis < 3; ++axis) b.put(frame_.relative(scene_.near_points[i][axis], axis));
    });
  }

  void write_links() {
    block(scene_.links.size(), [&](Base64Writer& b, std::size_t i) {
      b.put(scene_.links[i].from);
      b.put(scene_.links[i].to);
    });
  }

  bool pairs_have_points() const {
    return std::ranges::any_of(scene_.pairs, [](const ScenePair& pair) {
      return std::min(pair.birth_point, pair.death_point) != never_in_scene;
    });
  }

  std::vector<std::uint32_t> pair_points() const {
    std::vector<std::uint32_t> points;
    for (const ScenePair& pair : scene_.pairs) points.insert(points.end(), {pair.birth_point, pair.death_point});
    return points;
  }

  void write_pairs() {
    block(scene_.pairs.size(), [&](Base64Writer& b, std::size_t i) {
      const ScenePair& pair = scene_.pairs[i];
      for (const std::uint32_t number : {pair.degree, pair.birth, pair.death}) b.put(number);
    });
  }

  std::ostream& out_;
  const LayeredScene& scene_;
  SceneFrame frame_;
  bool is_single_ = false;
  std::vector<LaidOut> layers_;
  std::size_t announced_ = 0;
  std::size_t blocks_ = 0;
};

}  // namespace

void write_layered_page(std::ostream& out, const LayeredScene& scene) {
  if (!has_view()) throw Error("the browser view was not built into this quoin (configure with -DQUOIN_VIEW=ON)");
  write_layered_page(out, scene, built_layers_template());
}

void write_layered_page(std::ostream& out, const LayeredScene& scene, std::string_view page_template) {
  const page_text::Template page = page_text::split_template(page_template);
  check_layered_scene(scene);
  out << page.before_title;
  page_text::write_title(out, scene.title);
  out << page.before_scene;
  LayeredPage(out, scene).write();
  out << page.rest;
}

}  // namespace quoin
