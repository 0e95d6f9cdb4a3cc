// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/point_scenes.h"

#include <algorithm>
#include <numeric>

#include "quoin/base/polled_resize.h"

namespace quoin::cli {

namespace {

constexpr std::size_t poll_step = 4096;
// More are hidden at first: those of space would hide everything else.
constexpr std::size_t most_edges_of_space = 2000;
constexpr std::size_t most_edges_of_plane = 200'000;
constexpr Color point_color{47, 95, 158, 255};
constexpr Color edge_color{105, 116, 132, 255};
constexpr Color face_color{125, 158, 198, 255};
constexpr Color see_through{125, 158, 198, 70};

using Edge = std::array<std::uint32_t, 2>;

/// `visit(a, b)` for each edge of each simplex, a < b.
template <class Visit>
void for_each_edge(const TriangulatedPoints& made, const Context& context, const Visit& visit) {
  const auto size = static_cast<std::size_t>(made.dimension) + 1;
  for (std::size_t i = 0; i < made.simplices.size(); ++i) {
    if (i % poll_step == 0) context.poll();
    const auto& v = made.simplices[i];
    for (std::size_t b = 1; b < size; ++b) {
      for (std::size_t a = 0; a < b; ++a) visit(std::min(v[a], v[b]), std::max(v[a], v[b]));
    }
  }
}

/// The edges of the simplices in their order, each once: in buckets by the first vertex, then within these.
std::vector<Edge> edges_of(const TriangulatedPoints& made, const Context& context) {
  std::vector<std::size_t> end(made.first_input.size() + 1, 0);  // at first: where the bucket before ends
  for_each_edge(made, context, [&](std::uint32_t a, std::uint32_t) { ++end[a + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<std::uint32_t> others;
  resize_and_poll(others, end.back(), context);
  for_each_edge(made, context, [&](std::uint32_t a, std::uint32_t b) { others[end[a]++] = b; });
  std::vector<Edge> edges;
  auto from = others.begin();
  for (std::uint32_t a = 0; a < made.first_input.size(); ++a) {
    if (a % poll_step == 0) context.poll();
    const auto to = others.begin() + static_cast<std::ptrdiff_t>(end[a]);
    std::sort(from, to);
    std::for_each(from, std::unique(from, to), [&](std::uint32_t b) { edges.push_back({a, b}); });
    from = to;
  }
  return edges;
}

}  // namespace

LayeredScene scene_of_points(const PointFile& file, std::span<const std::uint32_t> first_input) {
  LayeredScene scene;
  SceneLayer layer{.name = "Points", .kind = SceneLayer::Kind::points, .color = point_color};
  for (std::uint32_t v = 0; v < first_input.size(); ++v) {
    scene.points.push_back(file.points[first_input[v]]);
    layer.vertices.push_back(v);
    if (!file.colors.empty()) layer.colors.push_back(file.colors[first_input[v]]);
  }
  scene.point_numbers.assign(first_input.begin(), first_input.end());
  scene.layers.push_back(std::move(layer));
  return scene;
}

LayeredScene scene_of_graph(const AlphaPoints& points, const VertexPairs& edges, const std::string& name,
                            const PointFile& file) {
  LayeredScene scene = scene_of_points(file, points.first_input);
  SceneLayer layer{.name = name, .kind = SceneLayer::Kind::segments, .color = edge_color};
  for (const auto& [a, b] : edges) layer.vertices.insert(layer.vertices.end(), {a, b});
  scene.layers.push_back(std::move(layer));
  return scene;
}

LayeredScene scene_of_triangulation(const TriangulatedPoints& made, const PointFile& file, const Context& context) {
  LayeredScene scene = scene_of_points(file, made.first_input);
  SceneLayer faces{.name = made.dimension == 3 ? "Hull" : "Triangles", .kind = SceneLayer::Kind::triangles};
  faces.color = made.dimension == 3 ? see_through : face_color;
  for (const auto& triangle : made.hull) faces.vertices.insert(faces.vertices.end(), triangle.begin(), triangle.end());
  if (made.dimension == 2) {
    for (const auto& t : made.simplices) faces.vertices.insert(faces.vertices.end(), t.begin(), t.begin() + 3);
  }
  SceneLayer lines{.name = "Edges", .kind = SceneLayer::Kind::segments, .color = edge_color};
  if (made.dimension > 0) {
    const auto edges = edges_of(made, context);
    scene.facts.emplace_back("Edges", std::to_string(edges.size()));
    if (edges.size() > most_edges_drawn) scene.facts.emplace_back("Not in this page", "the edges: too many");
    if (edges.size() <= most_edges_drawn) {
      for (const auto& edge : edges) lines.vertices.insert(lines.vertices.end(), edge.begin(), edge.end());
    }
    lines.is_shown = edges.size() <= (made.dimension == 3 ? most_edges_of_space : most_edges_of_plane);
  }
  SceneLayer rim{.name = "Edges of the hull", .kind = SceneLayer::Kind::segments, .color = edge_color};
  for (const auto& [a, b, c] : made.hull) {
    for (const auto& [from, to] : {std::array{a, b}, {b, c}, {c, a}}) {  // each edge is that of two triangles
      if (from < to) rim.vertices.insert(rim.vertices.end(), {from, to});
    }
  }
  rim.is_shown = rim.vertices.size() / 2 <= most_edges_of_plane;
  for (SceneLayer* layer : {&faces, &rim, &lines}) {
    if (!layer->vertices.empty()) scene.layers.push_back(std::move(*layer));
  }
  return scene;
}

}  // namespace quoin::cli
