// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "quoin/cli/flow_layers.h"
#include "quoin/cli/flow_page.h"
#include "quoin/cli/flow_scene_parts.h"
#include "quoin/cli/flow_sheets.h"
#include "quoin/cli/scene_box.h"

namespace quoin::cli {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;
constexpr Color sheet_color{214, 160, 110, 110};

/// Adds polygons to a layer as triangles, and corners to the scene once they are needed.
class SheetLayer {
 public:
  SheetLayer(const char* name, bool is_shown, const SceneBox& box, LayeredScene& scene)
      : box_(box),
        scene_(scene),
        layer_{.name = name, .kind = SceneLayer::Kind::triangles, .color = sheet_color, .is_shown = is_shown} {}

  bool is_far(const SheetPolygons& sheets, std::size_t i) const {
    return !std::ranges::all_of(sheets.polygon(i), [&](std::uint32_t c) { return box_.holds(sheets.points[c]); });
  }
  void add(const SheetPolygons& sheets, std::size_t i) {
    place_.resize(sheets.points.size(), none);
    const std::span<const std::uint32_t> corners = sheets.polygon(i);
    for (const std::uint32_t c : corners) {
      if (place_[c] != none) continue;
      place_[c] = static_cast<std::uint32_t>(scene_.point_count());
      scene_.near_points.push_back(sheets.points[c]);
    }
    for (std::size_t k = 2; k < corners.size(); ++k) {
      layer_.vertices.insert(layer_.vertices.end(), {place_[corners[0]], place_[corners[k - 1]], place_[corners[k]]});
    }
  }
  /// What comes is of other polygons.
  void forget_corners() { place_.clear(); }
  void say(std::size_t count, const char* what) {
    if (count > 0) scene_.facts.emplace_back(layer_.name, std::to_string(count) + " " + what);
  }
  std::size_t triangles() const { return layer_.vertices.size() / 3; }
  SceneLayer& layer() { return layer_; }

 private:
  const SceneBox& box_;
  LayeredScene& scene_;
  std::vector<std::uint32_t> place_;  // in the scene
  SceneLayer layer_;
};

/// Each part once.
SceneLayer all_together(const FlowCells& flow, const SceneBox& box, LayeredScene& scene, const Context& context) {
  const SheetPolygons sheets = sheet_polygons(flow, context);
  SheetLayer made("Sheets (unstable 1)", true, box, scene);
  std::size_t far = sheets.unbounded;
  std::size_t left = 0;
  for (std::size_t i = 0; i < sheets.count(); ++i) {
    if (i % 1024 == 0) context.poll();
    if (made.is_far(sheets, i)) {
      ++far;
    } else if (made.triangles() >= most_flow_triangles) {
      ++left;
    } else {
      made.add(sheets, i);
    }
  }
  made.say(far, "pieces go far beyond the points or to infinity, and are not drawn");
  made.say(left, "pieces are left out: they are too many for a page");
  return std::move(made.layer());
}

/// Each sheet by itself, with what it shares with others: seen where its midpoint is picked.
SceneLayer one_by_one(const FlowGraph& graph, const FlowGrades& grades, const FlowPlaces& places,
                      const PageValues& stops, const SceneBox& box, LayeredScene& scene, const Context& context) {
  SheetLayer made("Single sheets (unstable 1)", false, box, scene);
  SceneLayer& layer = made.layer();
  SheetPolygonMaker maker(graph.cells(), SheetParts::all);
  std::size_t points_before = scene.near_points.size();  // those of sheets that begin before the last stop
  for (const std::uint32_t i : grades.edges_in_order()) {
    const std::uint32_t stop = stops.stop_of(grades.of_edge(i));
    if (layer.begin.empty() || layer.begin.back() != stop) points_before = scene.near_points.size();
    maker.add(grades.edges()[i].cell, grades.edges()[i].edge, i, context);
    const SheetPolygons sheet = maker.take();
    made.forget_corners();
    for (std::size_t k = 0; k < sheet.count(); ++k) {
      if (k % 1024 == 0) context.poll();
      if (!made.is_far(sheet, k)) made.add(sheet, k);
    }
    layer.begin.resize(made.triangles(), stop);
    layer.owners.resize(made.triangles(), places.owner_of_edge(i));
    if (made.triangles() > most_picked_triangles) {
      cut_layer(layer, stop, stops, scene);
      scene.near_points.resize(points_before);
      break;
    }
  }
  return std::move(layer);
}

/// One that nothing in the scene has.
std::uint32_t free_owner(const LayeredScene& scene) {
  std::uint32_t free = 0;
  for (const SceneLayer& layer : scene.layers) {
    for (const std::uint32_t owner : layer.owners) free = std::max(free, owner + 1);
  }
  for (const SceneLink& link : scene.links) free = std::max({free, link.from + 1, link.to + 1});
  return free;
}

}  // namespace

void add_sheet_layers(const FlowGraph& graph, const FlowGrades& grades, const FlowPlaces& places,
                      const PageValues& stops, LayeredScene& scene, const Context& context) {
  context.progress("unstable sheets", 0);
  const SceneBox box(scene.points);
  SceneLayer together = all_together(graph.cells(), box, scene, context);
  SceneLayer each = one_by_one(graph, grades, places, stops, box, scene, context);
  // Where something is picked, its own is seen by itself, and not what is together.
  together.owners.assign(together.vertices.size() / 3, free_owner(scene));
  scene.layers.push_back(std::move(together));
  scene.layers.push_back(std::move(each));
}

}  // namespace quoin::cli
