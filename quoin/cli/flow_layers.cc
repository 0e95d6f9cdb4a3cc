// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/flow_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "quoin/view/scene_frame.h"

namespace quoin::cli {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

std::uint64_t key_of(const std::array<std::uint32_t, 2>& edge) {
  const auto [low, high] = std::minmax(edge[0], edge[1]);
  return static_cast<std::uint64_t>(low) << 32 | high;
}

/// For points that are drawn and not told: within a part in four thousand of the size of the scene, a fraction of a
/// pixel, by bounds that are much wider than errors are.
double precision_of(const std::vector<Point3>& points) {
  SceneBounds bounds;
  double largest = 0;
  for (const Point3& p : points) {
    bounds.include(p);
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  return 0x1p-12 * (bounds.frame().scale / 2 / largest);
}

}  // namespace

SurfaceLayers::SurfaceLayers(const FlowGraph& graph, const FlowGrades& grades, const FlowPlaces& places,
                             LayeredScene& scene)
    : graph_(graph),
      places_(places),
      scene_(scene),
      surfaces_(graph.cells()),
      unscale_(graph.cells().triangulation().unscale()),
      precision_(precision_of(scene.points)) {
  for (std::uint32_t i = 0; i < grades.edges().size(); ++i) {
    const auto [cell, edge] = grades.edges()[i];
    const auto& vertices = graph.cells().cells()[cell].vertices;
    midpoints_.emplace(key_of({vertices[edge_slots[edge][0]], vertices[edge_slots[edge][1]]}), places.first_edge + i);
  }
}

void SurfaceLayers::add(std::uint32_t saddle, std::uint32_t stop, SceneLayer& layer, const Context& context) {
  const SurfacePieces& surface = surfaces_.follow(graph_.saddles()[saddle].facet, context);
  not_ordinary_ += surface.is_ordinary() ? 0 : 1;
  constructed_.assign(surfaces_.chain().size(), none);
  for (const SurfacePiece& piece : surface.pieces) {
    const std::uint32_t to = constructed(piece.towards);
    const std::uint32_t from = piece.from == CrossingChain::none ? midpoint(piece.edge) : constructed(piece.from);
    layer.vertices.insert(layer.vertices.end(), {piece.edge[0], from, to, piece.edge[1], to, from});
  }
  const std::size_t count = layer.vertices.size() / 3;
  layer.begin.resize(count, stop);
  layer.owners.resize(count, places_.owner_of_saddle(saddle));
}

std::uint32_t SurfaceLayers::midpoint(const std::array<std::uint32_t, 2>& edge) {
  const auto [at, is_new] = midpoints_.try_emplace(key_of(edge), 0);
  if (is_new) {
    const Point3& a = graph_.cells().triangulation().point(edge[0]);
    const Point3& b = graph_.cells().triangulation().point(edge[1]);
    at->second = add_near_point(scene_, {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2});
  }
  return at->second;
}

std::uint32_t SurfaceLayers::constructed(std::uint32_t node) {
  if (constructed_[node] == none) {
    const Point3 p = surfaces_.chain().near_point(node, precision_);
    constructed_[node] = add_near_point(scene_, {p.x * unscale_, p.y * unscale_, p.z * unscale_});
  }
  return constructed_[node];
}

WayLayer::WayLayer(const FlowGraph& graph, const FlowPlaces& places, LayeredScene& scene)
    : graph_(graph),
      places_(places),
      scene_(scene),
      values_(graph.cells().triangulation()),
      arcs_(graph.cells()),
      segments_(scene),
      owner_(graph.cells().cells().size(), none),
      centre_(graph.cells().cells().size(), none),
      precision_(precision_of(scene.points)),
      next_owner_(places.owner_of_maximum(graph.infinity())) {
  for (std::uint32_t i = 0; i < graph.maxima().size(); ++i) {
    const std::uint32_t cell = graph.maxima()[i].cell;
    const std::uint32_t point = places.first_maximum + i;
    owner_[cell] = places.owner_of_maximum(i);
    centre_[cell] = static_cast<std::uint32_t>(spots_.size());
    spots_.push_back({scene.near_points[point - scene.points.size()], point});
  }
}

void WayLayer::add(std::uint32_t saddle, std::uint32_t stop, SceneLayer& layer, const Context& context) {
  const CellFacet facet = graph_.saddles()[saddle].facet;
  arcs_.ends(facet, context);
  const std::uint32_t point = places_.first_saddle + saddle;
  for (const std::uint32_t side : {facet.cell, graph_.cells().mate(facet).cell}) {
    if (graph_.cells().is_ghost(side)) continue;
    const std::uint32_t first = graph_.cells().first_of(side);
    const std::uint32_t next = centre(first);
    SceneSpot from{scene_.near_points[point - scene_.points.size()], point};
    segments_.draw(from, spots_[next], places_.owner_of_saddle(saddle), stop, layer);
    follow(places_.owner_of_saddle(saddle), first, stop, layer, context);
  }
}

/// From a Voronoi vertex on, as far as no other way has drawn; up to where it leaves the box.
void WayLayer::follow(std::uint32_t from, std::uint32_t cell, std::uint32_t stop, SceneLayer& layer,
                      const Context& context) {
  for (std::size_t steps = 1;; ++steps) {
    if (steps % 64 == 0) context.poll();
    const bool is_new = owner_[cell] == none;
    if (is_new) owner_[cell] = next_owner_++;
    scene_.links.push_back({from, owner_[cell]});
    SceneSpot at = spots_[centre(cell)];
    if (!is_new || !segments_.box().holds(at.at)) return;  // out there all leads to infinity
    from = owner_[cell];
    const std::optional<ArcLeg> leg = arcs_.way_on(cell, context, precision_);
    if (!leg) return;
    for (const Point3& p : leg->points) {
      SceneSpot next{p};
      segments_.draw(at, next, from, stop, layer);
      if (!segments_.box().holds(p)) return;
      at = next;
    }
    std::optional<std::uint32_t> next = leg->next;
    if (!next) {  // in another saddle, on from there, or to infinity
      const SaddleEnd end = arcs_.end(cell, context);
      if (end.kind != SaddleEnd::Kind::saddle || graph_.cells().is_ghost(end.cell)) return;
      arcs_.end(end.cell, context);
      next = graph_.cells().first_of(end.cell);
    }
    segments_.draw(at, spots_[centre(*next)], from, stop, layer);
    cell = *next;
  }
}

/// The spot of a Voronoi vertex.
std::uint32_t WayLayer::centre(std::uint32_t cell) {
  if (centre_[cell] == none) {
    centre_[cell] = static_cast<std::uint32_t>(spots_.size());
    spots_.push_back({values_.near_centre(cell), none});
  }
  return centre_[cell];
}

}  // namespace quoin::cli
