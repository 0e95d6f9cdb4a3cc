// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <span>
#include <string>

#include "quoin/cli/flow_layers.h"
#include "quoin/cli/flow_page.h"
#include "quoin/cli/flow_sheets.h"

namespace quoin::cli {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;
constexpr Color sheet_color{214, 160, 110, 110};

class SheetLayer {
 public:
  SheetLayer(const SheetPolygons& sheets, LayeredScene& scene)
      : sheets_(sheets), scene_(scene), place_(sheets.points.size(), none) {}

  /// Triangles of a polygon.
  void add(std::span<const std::uint32_t> corners) {
    for (const std::uint32_t c : corners) {
      if (place_[c] != none) continue;
      place_[c] = static_cast<std::uint32_t>(scene_.point_count());
      scene_.near_points.push_back(sheets_.points[c]);
    }
    for (std::size_t k = 2; k < corners.size(); ++k) {
      layer_.vertices.insert(layer_.vertices.end(), {place_[corners[0]], place_[corners[k - 1]], place_[corners[k]]});
    }
  }
  bool has_room() const { return layer_.vertices.size() < 3 * most_flow_triangles; }

  void say(std::size_t count, const char* what) {
    if (count > 0) scene_.facts.emplace_back(layer_.name, std::to_string(count) + " " + what);
  }
  void finish() { scene_.layers.push_back(std::move(layer_)); }

 private:
  const SheetPolygons& sheets_;
  LayeredScene& scene_;
  std::vector<std::uint32_t> place_;  // in the scene
  SceneLayer layer_{.name = "Sheets (unstable 1)", .kind = SceneLayer::Kind::triangles, .color = sheet_color};
};

}  // namespace

void add_sheet_layer(const FlowCells& flow, LayeredScene& scene, const Context& context) {
  context.progress("unstable sheets", 0);
  const SheetPolygons sheets = sheet_polygons(flow, context);
  const SceneBox box(scene.points);
  SheetLayer layer(sheets, scene);
  std::size_t far = sheets.unbounded;
  std::size_t left = 0;
  for (std::size_t i = 0; i + 1 < sheets.begin.size(); ++i) {
    if (i % 1024 == 0) context.poll();
    const auto corners = std::span(sheets.corners).subspan(sheets.begin[i], sheets.begin[i + 1] - sheets.begin[i]);
    if (!std::ranges::all_of(corners, [&](std::uint32_t c) { return box.holds(sheets.points[c]); })) {
      ++far;
    } else if (!layer.has_room()) {
      ++left;
    } else {
      layer.add(corners);
    }
  }
  layer.say(far, "pieces go far beyond the points or to infinity, and are not drawn");
  layer.say(left, "pieces are left out: they are too many for a page");
  layer.finish();
}

}  // namespace quoin::cli
