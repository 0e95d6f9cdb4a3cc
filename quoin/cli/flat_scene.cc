// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/flat_scene.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "quoin/cli/clipped_segments.h"
#include "quoin/cli/flat_grades.h"
#include "quoin/cli/flow_scene_parts.h"
#include "quoin/cli/page_values.h"
#include "quoin/cli/point_scenes.h"
#include "quoin/flow/critical_values.h"

namespace quoin::cli {

namespace {

using Kind = SceneLayer::Kind;

constexpr std::uint32_t none = SceneSpot::none;
constexpr std::size_t poll_step = 1024;

/// Straight across a side of a polygon, out of it, in its plane; the largest coordinate is 1 or -1.
Vector3 outward(const FlowComplex& flow, std::uint32_t edge, std::uint32_t apex) {
  const auto [a, b] = flow.faces().edge(edge);
  const RationalPoint3 from = exact_point(flow.point(a));
  const RationalPoint3 along = exact_point(flow.point(b)) - from;
  const RationalPoint3 out = from - exact_point(flow.point(apex));
  const RationalPoint3 across = out - along * (dot(out, along) / dot(along, along));
  const Rational largest = std::max({abs(across.x), abs(across.y), abs(across.z)});
  return {(across.x / largest).to_double(), (across.y / largest).to_double(), (across.z / largest).to_double()};
}

/// Centres of faces as points of a scene: each once, those of critical faces first.
class FlatCentres {
 public:
  FlatCentres(const FlowComplex& flow, LayeredScene& scene) : flow_(flow), scene_(scene) {
    for (unsigned d = 1; d < 3; ++d) spots_[d].resize(flow.faces().count(d));
  }

  std::uint32_t point(DeloneFace face) {
    if (face.dimension == 0) return face.index;
    SceneSpot& spot = at(face);
    if (spot.point == none) spot.point = add_near_point(scene_, spot.at);
    return spot.point;
  }
  /// Of an edge or polygon.
  SceneSpot& at(DeloneFace face) {
    Place& place = spots_[face.dimension][face.index];
    if (!place.is_known) place = {{to_nearest_doubles(flow_.centre(face))}, true};
    return place.spot;
  }

 private:
  struct Place {
    SceneSpot spot;
    bool is_known = false;
  };
  const FlowComplex& flow_;
  LayeredScene& scene_;
  std::array<std::vector<Place>, 3> spots_;
};

/// Adds the ways of critical edges to a layer, as `WayLayer` does those of saddles of space. In the plane they join at
/// centres of polygons: each step from one is an owner, linked to the next.
class FlatWayLayer {
 public:
  FlatWayLayer(FlatFlow& flow, const FlatGrades& grades, FlatCentres& centres, LayeredScene& scene)
      : flow_(flow),
        grades_(grades),
        centres_(centres),
        scene_(scene),
        segments_(scene),
        owner_(flow.complex().faces().count(2), none),
        next_owner_(static_cast<std::uint32_t>(grades.edges().size() + grades.polygons().size())) {
    for (std::uint32_t i = 0; i < grades.polygons().size(); ++i)
      owner_[grades.polygons()[i]] = static_cast<std::uint32_t>(grades.edges().size()) + i;
  }

  /// The two ways of a critical edge, there from a stop on. Edges come by ascending stops. @throws Cancelled
  void add(std::uint32_t number, std::uint32_t stop, SceneLayer& layer, const Context& context) {
    const std::uint32_t edge = grades_.edges()[number];
    const std::span<const RingPolygon> ring = flow_.complex().faces().ring(edge);
    for (const RingPolygon& beside : ring) {
      segments_.draw(centres_.at({1, edge}), centres_.at({2, beside.polygon}), number, stop, layer);
      follow(number, beside.polygon, stop, layer, context);
    }
    if (ring.size() == 1) draw_outward(centres_.at({1, edge}), edge, ring[0].apex, number, stop, layer);
  }

 private:
  /// From the centre of a polygon on, as far as no other way has drawn; up to where it leaves the box.
  void follow(std::uint32_t from, std::uint32_t polygon, std::uint32_t stop, SceneLayer& layer,
              const Context& context) {
    for (std::size_t steps = 1;; ++steps) {
      if (steps % poll_step == 0) context.poll();
      const bool is_new = owner_[polygon] == none;
      if (is_new) owner_[polygon] = next_owner_++;
      scene_.links.push_back({from, owner_[polygon]});
      SceneSpot& at = centres_.at({2, polygon});
      if (!is_new || !segments_.box().holds(at.at)) return;  // out there all leads to infinity
      from = owner_[polygon];
      bool passes = false;
      const std::optional<std::uint32_t> edge = flow_.exit(polygon, passes);
      const std::uint32_t next = flow_.next(polygon, passes);
      if (next == FlatWay::infinity) {
        const std::size_t side = flow_.complex().faces().side_of(polygon, *edge);
        draw_outward(at, *edge, flow_.complex().faces().apex(polygon, side), from, stop, layer);
        return;
      }
      segments_.draw(at, centres_.at({2, next}), from, stop, layer);
      polygon = next;
    }
  }

  void draw_outward(SceneSpot& from, std::uint32_t edge, std::uint32_t apex, std::uint32_t owner, std::uint32_t stop,
                    SceneLayer& layer) {
    SceneSpot far{segments_.box().beyond(from.at, outward(flow_.complex(), edge, apex))};
    segments_.draw(from, far, owner, stop, layer);
  }

  FlatFlow& flow_;
  const FlatGrades& grades_;
  FlatCentres& centres_;
  LayeredScene& scene_;
  ClippedSegments segments_;
  std::vector<std::uint32_t> owner_;  // by polygon
  std::uint32_t next_owner_;
};

class FlatScene {
 public:
  FlatScene(FlatFlow& flow, const Delaunay3& triangulation, const FlowPage& page, const PointFile& file,
            const Context& context)
      : flow_(flow),
        complex_(flow.complex()),
        page_(page),
        context_(context),
        scene_(scene_of_points(file, first_inputs(triangulation))),
        grades_(complex_, context),
        first_edge_(static_cast<std::uint32_t>(scene_.points.size())),
        first_polygon_(first_edge_ + static_cast<std::uint32_t>(grades_.edges().size())),
        centres_(complex_, scene_),
        pairs_(pairs()),
        stops_({grades_.count(), [this](std::uint32_t grade) { return grades_.square(grade); }, true}, pairs_, shown(),
               context) {}

  LayeredScene make() {
    scene_.value_name = "Squared";
    scene_.root_name = "Distance";
    add_points();
    add_counts();
    stops_.add_pairs(pairs_, scene_);
    if (page_.edges) add_edges();
    if (page_.surfaces && complex_.faces().dimension() == 2) add_surfaces();
    if (page_.ways && complex_.faces().dimension() == 2) add_ways();
    if (!page_.left_out.empty()) scene_.facts.emplace_back("Not in this page", page_.left_out);
    stops_.move_to(scene_);
    return std::move(scene_);
  }

 private:
  std::uint32_t owner_of_polygon(std::uint32_t i) const { return first_polygon_ - first_edge_ + i; }

  std::optional<std::uint32_t> shown() const {
    if (page_.distance) return grades_.up_to(*page_.distance);
    return std::nullopt;
  }

  std::vector<GradedPair> pairs() {
    std::vector<GradedPair> pairs{{.degree = 0}};
    for (const std::uint32_t i : joining_edges(complex_, grades_, context_))
      pairs.push_back({.degree = 0, .death = grades_.of_edge(i), .death_point = first_edge_ + i});
    for (const FlatHole& hole : holes_of(flow_, grades_, context_)) {
      pairs.push_back({1, grades_.of_edge(hole.edge), grades_.of_polygon(hole.polygon), first_edge_ + hole.edge,
                       first_polygon_ + hole.polygon});
    }
    return pairs;
  }

  /// Critical points by index, numbered as in other outputs.
  void add_points() {
    scene_.layers[0].name = "Points (index 0)";
    scene_.layers[0].color = color_of_index[0];
    scene_.layers[0].is_shown = !page_.surfaces || scene_.points.size() <= most_on_surfaces;
    if (complex_.faces().dimension() > 0) {
      add_layer({.name = "Midpoints (index 1)", .color = color_of_index[1], .element_name = "Midpoint"}, 1,
                grades_.edges(), [this](std::uint32_t i) { return grades_.of_edge(i); });
    }
    if (complex_.faces().dimension() > 1) {
      add_layer({.name = "Maxima (index 2)", .color = color_of_index[2], .element_name = "Maximum"}, 2,
                grades_.polygons(), [this](std::uint32_t i) { return grades_.of_polygon(i); });
    }
  }

  template <class GradeOf>
  void add_layer(SceneLayer layer, unsigned dimension, std::span<const std::uint32_t> faces, const GradeOf& grade_of) {
    const bool has_owned = page_.edges || page_.surfaces || page_.ways;
    for (std::uint32_t i = 0; i < faces.size(); ++i) {
      if (i % poll_step == 0) context_.poll();
      const std::uint32_t point = centres_.point({dimension, faces[i]});
      scene_.point_numbers.push_back(i);
      layer.vertices.push_back(point);
      layer.begin.push_back(stops_.stop_of(grade_of(i)));
      if (has_owned) layer.owners.push_back(point - first_edge_);
    }
    layer.is_shown = faces.size() <= most_critical_at_first;
    scene_.layers.push_back(std::move(layer));
  }

  void add_counts() {
    const auto dimension = static_cast<std::size_t>(complex_.faces().dimension());
    std::vector<PageTally> of_index(dimension + 1, PageTally(stops_));
    std::vector<PageTally> betti(std::max<std::size_t>(dimension, 1), PageTally(stops_));
    for (std::size_t v = 0; v < scene_.points.size(); ++v) of_index[0].come(0);
    // Each component but the one that stays was a point of its own.
    for (const GradedPair& pair : pairs_) {
      betti[pair.degree].come(pair.birth);
      betti[pair.degree].go(pair.death);
    }
    for (std::uint32_t i = 0; i < grades_.edges().size(); ++i) of_index[1].come(grades_.of_edge(i));
    for (std::uint32_t i = 0; i < grades_.polygons().size(); ++i) of_index[2].come(grades_.of_polygon(i));
    SceneCounts counts{.name = "Critical points"};
    for (std::size_t i = 0; i < of_index.size(); ++i)
      counts.rows.push_back(of_index[i].take("Index " + std::to_string(i)));
    SceneCounts numbers{.name = "Betti numbers"};
    static constexpr std::array names{"Components", "Holes"};
    for (std::size_t i = 0; i < betti.size(); ++i) numbers.rows.push_back(betti[i].take(names[i]));
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
      const std::array<std::uint32_t, 2> ends = complex_.faces().edge(grades_.edges()[i]);
      layer.vertices.insert(layer.vertices.end(), ends.begin(), ends.end());
      layer.begin.push_back(stop);
      layer.owners.push_back(i);
      // Where ways are, they say so.
      if (!page_.ways) link_to_maxima(i);
    }
    layer.is_shown = layer.begin.size() <= most_edges_at_first;
    scene_.layers.push_back(std::move(layer));
  }

  void link_to_maxima(std::uint32_t edge) {
    for (const FlatWay& way : flow_.ways(grades_.edges()[edge], context_)) {
      if (way.end == FlatWay::infinity) continue;
      const auto at = std::lower_bound(grades_.polygons().begin(), grades_.polygons().end(), way.end);
      scene_.links.push_back({edge, owner_of_polygon(static_cast<std::uint32_t>(at - grades_.polygons().begin()))});
    }
  }

  void add_surfaces() {
    context_.progress("surfaces", 0);
    SceneLayer layer{.name = "Surfaces (stable 2)", .kind = Kind::triangles, .color = stable_surface_color};
    for (const std::uint32_t i : grades_.polygons_in_order()) {
      const std::uint32_t stop = stops_.stop_of(grades_.of_polygon(i));
      if (layer.begin.size() >= most_flow_triangles) {
        cut_layer(layer, stop, stops_, scene_);
        break;
      }
      const StableSurface surface = stable_surface(complex_, grades_.polygons()[i], context_);
      for (const StableTriangle& t : surface.triangles) {
        layer.vertices.insert(layer.vertices.end(), {t.vertex, centres_.point(surface.points.face(t.from)),
                                                     centres_.point(surface.points.face(t.towards))});
        layer.begin.push_back(stop);
        layer.owners.push_back(owner_of_polygon(i));
      }
    }
    scene_.layers.push_back(std::move(layer));
  }

  void add_ways() {
    context_.progress("ways to maxima", 0);
    SceneLayer layer{.name = "Ways (unstable 1)", .kind = Kind::segments, .color = way_color};
    FlatWayLayer ways(flow_, grades_, centres_, scene_);
    std::size_t steps = 0;
    for (const std::uint32_t i : grades_.edges_in_order()) {
      if (++steps % poll_step == 0) context_.poll();
      const std::uint32_t stop = stops_.stop_of(grades_.of_edge(i));
      if (layer.begin.size() >= most_flow_segments) {
        cut_layer(layer, stop, stops_, scene_);
        break;
      }
      ways.add(i, stop, layer, context_);
    }
    layer.is_shown = layer.begin.size() <= most_ways_at_first;
    scene_.layers.push_back(std::move(layer));
  }

  FlatFlow& flow_;
  const FlowComplex& complex_;
  const FlowPage& page_;
  const Context& context_;
  LayeredScene scene_;
  FlatGrades grades_;
  std::uint32_t first_edge_;  // points of the scene
  std::uint32_t first_polygon_;
  FlatCentres centres_;
  std::vector<GradedPair> pairs_;
  PageValues stops_;
};

}  // namespace

LayeredScene scene_of_flat_flow(FlatFlow& flow, const Delaunay3& triangulation, const FlowPage& page,
                                const PointFile& file, const Context& context) {
  return FlatScene(flow, triangulation, page, file, context).make();
}

}  // namespace quoin::cli
