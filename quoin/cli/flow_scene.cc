// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/flow_scene.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "quoin/base/disjoint_sets.h"
#include "quoin/cli/flow_layers.h"
#include "quoin/cli/flow_scene_parts.h"
#include "quoin/cli/flow_tunnels.h"
#include "quoin/cli/page_values.h"
#include "quoin/cli/point_scenes.h"

namespace quoin::cli {

namespace {

using Kind = SceneLayer::Kind;

constexpr std::size_t poll_step = 4096;
// Of critical points near the surface: lighter.
constexpr std::array<Color, 4> color_of_surface{Color{47, 111, 181, 255}, Color{236, 168, 180, 255},
                                                Color{150, 208, 180, 255}, Color{200, 176, 224, 255}};
constexpr Color wall_color{125, 158, 198, 255};
constexpr Color other_color{150, 150, 158, 255};

class FlowScene {
 public:
  FlowScene(const FlowGraph& graph, const FlowPage& page, const PointFile& file, const Context& context)
      : graph_(graph),
        page_(page),
        context_(context),
        scene_(scene_of_points(file, first_inputs(graph.cells().triangulation()))),
        grades_(graph, context),
        pairs_(pairs()),
        stops_({grades_.count(), [this](std::uint32_t grade) { return grades_.square(grade); }, true}, pairs_, shown(),
               context) {}

  LayeredScene make() {
    scene_.value_name = "Squared";
    scene_.root_name = "Distance";
    add_points();
    add_counts();
    stops_.add_pairs(pairs_, scene_);
    if (!page_.tunnels) scene_.facts.emplace_back("Diagram", "components and voids; tunnels are counted, not paired");
    if (page_.edges) add_edges();
    if (page_.surfaces) add_surfaces();
    if (!page_.wall_name.empty()) add_walls();
    if (page_.ways) add_ways();
    if (page_.sheets) add_sheet_layers(graph_, grades_, places_, stops_, scene_, context_);
    if (!page_.left_out.empty()) scene_.facts.emplace_back("Not in this page", page_.left_out);
    stops_.move_to(scene_);
    return std::move(scene_);
  }

 private:
  std::optional<std::uint32_t> shown() const {
    if (page_.distance) return grades_.up_to(*page_.distance);
    if (!page_.wall_name.empty()) return grades_.count();
    return std::nullopt;
  }

  /// Components end at critical edges that join them, voids begin at saddles that cut them off.
  std::vector<GradedPair> pairs() {
    const auto vertices = static_cast<std::uint32_t>(scene_.points.size());
    places_.first_edge = vertices;
    places_.first_saddle = places_.first_edge + static_cast<std::uint32_t>(grades_.edges().size());
    places_.first_maximum = places_.first_saddle + static_cast<std::uint32_t>(graph_.saddles().size());
    std::vector<GradedPair> pairs{{.degree = 0}};
    DisjointSets components(vertices);
    for (const std::uint32_t i : grades_.edges_in_order()) {
      const std::array<std::uint32_t, 2> ends = ends_of(i);
      const std::uint32_t a = components.find(ends[0]);
      const std::uint32_t b = components.find(ends[1]);
      if (a == b) continue;
      components.unite(a, b);
      pairs.push_back({.degree = 0, .death = grades_.of_edge(i), .death_point = places_.first_edge + i});
    }
    for (const FlowGraph::Pair& pair : graph_.pairs(context_)) {
      pairs.push_back({2, grades_.of_saddle(pair.saddle), grades_.of_maximum(pair.maximum),
                       places_.first_saddle + pair.saddle, places_.first_maximum + pair.maximum});
    }
    if (page_.tunnels) {
      const std::vector<GradedPair> tunnels = tunnels_of(graph_, grades_, places_, context_);
      pairs.insert(pairs.end(), tunnels.begin(), tunnels.end());
    }
    return pairs;
  }

  std::array<std::uint32_t, 2> ends_of(std::uint32_t edge) const {
    const CriticalEdge& at = grades_.edges()[edge];
    const auto& vertices = graph_.cells().cells()[at.cell].vertices;
    return {vertices[edge_slots[at.edge][0]], vertices[edge_slots[at.edge][1]]};
  }

  /// Whether critical points of an index own something in the page.
  bool has_owned(std::size_t index) const {
    return page_.edges || page_.surfaces || page_.ways || has_walls() || (page_.sheets && index == 1);
  }
  bool has_walls() const { return !page_.wall_name.empty(); }
  bool has_surfaces() const { return page_.surfaces || has_walls(); }

  /// Critical points by index, numbered as in other outputs.
  void add_points() {
    const CriticalValues values(graph_.cells().triangulation());
    const auto add = [&](const Point3& p, std::uint32_t number) {
      if (number % poll_step == 0) context_.poll();
      scene_.near_points.push_back(p);
      scene_.point_numbers.push_back(number);
    };
    for (std::uint32_t i = 0; i < grades_.edges().size(); ++i)
      add(values.near_midpoint(grades_.edges()[i].cell, grades_.edges()[i].edge), i);
    for (std::uint32_t i = 0; i < graph_.saddles().size(); ++i) add(values.near_centre(graph_.saddles()[i].facet), i);
    for (std::uint32_t i = 0; i < graph_.maxima().size(); ++i) add(values.near_centre(graph_.maxima()[i].cell), i);
    scene_.layers[0].name = "Points (index 0)";
    scene_.layers[0].color = color_of_index[0];
    scene_.layers[0].is_shown = !has_surfaces() || scene_.points.size() <= most_on_surfaces;
    const CriticalSeparation* separated = page_.separation ? &*page_.separation : nullptr;
    add_separated("Midpoints (index 1", "Midpoint", 1, places_.first_edge, grades_.edges().size(),
                  separated != nullptr ? &separated->edges : nullptr,
                  [this](std::uint32_t i) { return grades_.of_edge(i); });
    add_separated("Saddles (index 2", "Saddle", 2, places_.first_saddle, graph_.saddles().size(),
                  separated != nullptr ? &separated->saddles : nullptr,
                  [this](std::uint32_t i) { return grades_.of_saddle(i); });
    const auto of_maximum = [this](std::uint32_t i) { return grades_.of_maximum(i); };
    if (page_.chosen.empty()) {
      add_separated("Maxima (index 3", "Maximum", 3, places_.first_maximum, graph_.maxima().size(),
                    separated != nullptr ? &separated->maxima : nullptr, of_maximum);
      return;
    }
    std::vector<bool> others = page_.chosen;
    others.flip();
    add_layer(page_.chosen_name, "Maximum", 3, places_.first_maximum, graph_.maxima().size(), page_.chosen, of_maximum);
    add_layer(page_.other_name, "Maximum", 3, places_.first_maximum, graph_.maxima().size(), others, of_maximum);
    scene_.layers.back().color = other_color;
    scene_.layers.back().is_shown = false;
  }

  /// One layer, or one of medial ones and one of those of the surface; the name's parenthesis is open.
  template <class GradeOf>
  void add_separated(const std::string& name, const char* of_one, std::size_t index, std::uint32_t first,
                     std::size_t count, const std::vector<bool>* medial, const GradeOf& grade_of) {
    if (medial == nullptr) {
      add_layer(name + ")", of_one, index, first, count, {}, grade_of);
      return;
    }
    add_layer(name + ", medial)", of_one, index, first, count, *medial, grade_of);
    std::vector<bool> others = *medial;
    others.flip();
    add_layer(name + ", surface)", of_one, index, first, count, others, grade_of);
    scene_.layers.back().color = color_of_surface[index];
  }

  template <class GradeOf>
  void add_layer(const std::string& name, const char* of_one, std::size_t index, std::uint32_t first, std::size_t count,
                 const std::vector<bool>& which, const GradeOf& grade_of) {
    SceneLayer layer{.name = name, .kind = Kind::points, .color = color_of_index[index], .element_name = of_one};
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!which.empty() && !which[i]) continue;
      layer.vertices.push_back(first + i);
      layer.begin.push_back(stops_.stop_of(grade_of(i)));
      if (has_owned(index)) layer.owners.push_back(first + i - places_.first_edge);
    }
    const std::size_t most_maxima = has_surfaces() ? most_on_surfaces : most_maxima_at_first;
    // Where sheets are, midpoints are there to be picked.
    const std::size_t most = page_.sheets && index == 1 ? most_on_surfaces : most_critical_at_first;
    layer.is_shown = index == 3 ? layer.vertices.size() <= most_maxima : !has_walls() && count <= most;
    scene_.layers.push_back(std::move(layer));
  }

  void add_counts() {
    SceneCounts counts{.name = "Critical points"};
    std::vector<PageTally> of_index(4, PageTally(stops_));
    std::vector<PageTally> betti(3, PageTally(stops_));
    for (std::size_t v = 0; v < scene_.points.size(); ++v) of_index[0].come(0);
    for (std::uint32_t i = 0; i < grades_.edges().size(); ++i) of_index[1].come(grades_.of_edge(i));
    for (std::uint32_t i = 0; i < graph_.saddles().size(); ++i) of_index[2].come(grades_.of_saddle(i));
    for (std::uint32_t i = 0; i < graph_.maxima().size(); ++i) of_index[3].come(grades_.of_maximum(i));
    // What joins no components begins a tunnel, what cuts no void off ends one.
    for (std::uint32_t i = 0; i < grades_.edges().size(); ++i) betti[1].come(grades_.of_edge(i));
    for (std::uint32_t i = 0; i < graph_.saddles().size(); ++i) betti[1].go(grades_.of_saddle(i));
    for (const GradedPair& pair : pairs_) {
      if (pair.degree == 1) continue;
      betti[pair.degree].come(pair.birth);
      betti[pair.degree].go(pair.death);
      if (pair.degree == 0) betti[1].go(pair.death);
      if (pair.degree == 2) betti[1].come(pair.birth);
    }
    for (std::size_t i = 0; i < 4; ++i) counts.rows.push_back(of_index[i].take("Index " + std::to_string(i)));
    SceneCounts numbers{.name = "Betti numbers"};
    static constexpr std::array names{"Components", "Tunnels", "Voids"};
    for (std::size_t i = 0; i < 3; ++i) numbers.rows.push_back(betti[i].take(names[i]));
    scene_.counts = {std::move(counts), std::move(numbers)};
  }

  void add_edges() {
    SceneLayer layer{.name = "Edges (stable 1)", .kind = Kind::segments, .color = stable_edge_color};
    for (const std::uint32_t i : grades_.edges_in_order()) {
      const std::uint32_t stop = stops_.stop_of(grades_.of_edge(i));
      if (layer.begin.size() >= most_flow_segments) {
        cut_layer(layer, stop, stops_, scene_);
        break;
      }
      const std::array<std::uint32_t, 2> ends = ends_of(i);
      layer.vertices.insert(layer.vertices.end(), ends.begin(), ends.end());
      layer.begin.push_back(stop);
      layer.owners.push_back(places_.owner_of_edge(i));
    }
    layer.is_shown = layer.begin.size() <= (has_surfaces() ? most_on_surfaces : most_edges_at_first);
    scene_.layers.push_back(std::move(layer));
  }

  /// Surfaces of saddles, which come by ascending distance.
  void add_surfaces_of(std::span<const std::uint32_t> saddles, SceneLayer layer) {
    SurfaceLayers surfaces(graph_, grades_, places_, scene_);
    for (const std::uint32_t i : saddles) {
      const std::uint32_t stop = stops_.stop_of(grades_.of_saddle(i));
      if (layer.begin.size() >= most_flow_triangles) {
        cut_layer(layer, stop, stops_, scene_);
        break;
      }
      surfaces.add(i, stop, layer, context_);
      // Where ways are, they say so.
      if (!page_.ways) link_to_maxima(i);
    }
    if (surfaces.not_ordinary() > 0)
      scene_.facts.emplace_back(layer.name, std::to_string(surfaces.not_ordinary()) + " not as in general position");
    scene_.layers.push_back(std::move(layer));
  }

  void link_to_maxima(std::uint32_t saddle) {
    for (const std::uint32_t end : graph_.saddles()[saddle].ends) {
      if (end != graph_.infinity())
        scene_.links.push_back({places_.owner_of_saddle(saddle), places_.owner_of_maximum(end)});
    }
  }

  void add_surfaces() {
    context_.progress("surfaces", 0);
    add_surfaces_of(grades_.saddles_in_order(),
                    {.name = "Surfaces (stable 2)", .kind = Kind::triangles, .color = stable_surface_color});
  }

  void add_walls() {
    context_.progress("surfaces", 0);
    std::vector<bool> is_wall(graph_.cells().cells().size() * 4, false);
    for (const WallSaddle& wall : page_.walls) is_wall[wall.facet.number()] = true;
    std::vector<std::uint32_t> saddles;
    for (const std::uint32_t i : grades_.saddles_in_order()) {
      if (is_wall[graph_.saddles()[i].facet.number()]) saddles.push_back(i);
    }
    add_surfaces_of(saddles, {.name = page_.wall_name, .kind = Kind::triangles, .color = wall_color});
  }

  void add_ways() {
    context_.progress("ways to maxima", 0);
    SceneLayer layer{.name = "Ways (unstable 2)", .kind = Kind::segments, .color = way_color};
    WayLayer ways(graph_, places_, scene_);
    for (const std::uint32_t i : grades_.saddles_in_order()) {
      const std::uint32_t stop = stops_.stop_of(grades_.of_saddle(i));
      if (layer.begin.size() >= most_flow_segments) {
        cut_layer(layer, stop, stops_, scene_);
        break;
      }
      ways.add(i, stop, layer, context_);
    }
    layer.is_shown = layer.begin.size() <= most_ways_at_first;
    scene_.layers.push_back(std::move(layer));
  }

  const FlowGraph& graph_;
  const FlowPage& page_;
  const Context& context_;
  LayeredScene scene_;
  FlowGrades grades_;
  FlowPlaces places_;
  std::vector<GradedPair> pairs_;
  PageValues stops_;
};

}  // namespace

LayeredScene scene_of_flow(const FlowGraph& graph, const FlowPage& page, const PointFile& file,
                           const Context& context) {
  return FlowScene(graph, page, file, context).make();
}

}  // namespace quoin::cli
