// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_reconstruction.h"

#include <algorithm>
#include <unordered_map>

#include "quoin/base/error.h"
#include "quoin/flow/saddle_surfaces.h"

namespace quoin {

namespace {

/// Whether the saddle's distance is at least the ratio of the maximum's.
bool is_open(const FlowGraph& graph, std::uint32_t saddle, std::uint32_t maximum, const Rational& ratio) {
  const Interval part = square(Interval::around(ratio)) * graph.maxima()[maximum].square;
  const Interval& at = graph.saddles()[saddle].square;
  if (at.lower() >= part.upper()) return true;
  if (at.upper() < part.lower()) return false;
  return graph.exact_square_of_saddle(saddle) >= ratio * ratio * graph.exact_square_of_maximum(maximum);
}

/// Saddles of each maximum, and of infinity.
struct SaddlesOfEnds {
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> list;

  explicit SaddlesOfEnds(const FlowGraph& graph) : begin(graph.maxima().size() + 2, 0) {
    for (const FlowGraph::Saddle& s : graph.saddles()) {
      for (const std::uint32_t end : s.ends) ++begin[end + 1];
    }
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    list.resize(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t i = 0; i < graph.saddles().size(); ++i) {
      for (const std::uint32_t end : graph.saddles()[i].ends) list[next[end]++] = i;
    }
  }
};

class MeshMaker {
 public:
  MeshMaker(const FlowCells& flow, const FlowMeshOptions& options)
      : flow_(flow), surfaces_(flow), unscale_(flow.triangulation().unscale()), options_(options) {}

  void add(const WallSaddle& wall, const Context& context) {
    const SurfacePieces& surface = surfaces_.follow(wall.facet, context);
    mesh_.not_ordinary += surface.is_ordinary() ? 0 : 1;
    constructed_.assign(surfaces_.chain().size(), none);
    for (const SurfacePiece& piece : surface.pieces) {
      const std::uint32_t to = constructed(piece.towards);
      const std::uint32_t from = piece.from == CrossingChain::none ? midpoint(piece.edge) : constructed(piece.from);
      // The front of the surface is on the side of the facet's simplex.
      const unsigned left = wall.is_inside_first ? 1 : 0;
      mesh_.triangles.push_back({corner(piece.edge[left]), from, to});
      mesh_.triangles.push_back({corner(piece.edge[1 - left]), to, from});
    }
    mesh_.saddle_of.resize(mesh_.triangles.size(), count_++);
  }
  FlowMesh take() { return std::move(mesh_); }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  std::uint32_t add_point(const RationalPoint3& p, std::uint32_t vertex = FlowMesh::constructed) {
    mesh_.vertex_of.push_back(vertex);
    mesh_.points.push_back(to_nearest_doubles(p));
    if (options_.keeps_exact_points) mesh_.exact_points.push_back(p);
    return static_cast<std::uint32_t>(mesh_.points.size() - 1);
  }
  std::uint32_t corner(std::uint32_t vertex) {
    const auto [at, is_new] = corners_.try_emplace(vertex, 0);
    if (is_new) at->second = add_point(exact_point(flow_.triangulation().point(vertex)), vertex);
    return at->second;
  }
  std::uint32_t midpoint(const std::array<std::uint32_t, 2>& edge) {
    const auto [low, high] = std::minmax(edge[0], edge[1]);
    const auto [at, is_new] = midpoints_.try_emplace(static_cast<std::uint64_t>(low) << 32 | high, 0);
    if (is_new) {
      const Rational half = Rational(1) / Rational(2);
      at->second = add_point(
          (exact_point(flow_.triangulation().point(low)) + exact_point(flow_.triangulation().point(high))) * half);
    }
    return at->second;
  }
  std::uint32_t constructed(std::uint32_t node) {
    if (constructed_[node] == none) {
      constructed_[node] = add_point(surfaces_.chain().exact_point(node) * unscale_);
    }
    return constructed_[node];
  }
  const FlowCells& flow_;
  SaddleSurfaces surfaces_;
  Rational unscale_;
  FlowMeshOptions options_;
  FlowMesh mesh_;
  std::unordered_map<std::uint32_t, std::uint32_t> corners_;
  std::unordered_map<std::uint64_t, std::uint32_t> midpoints_;
  std::vector<std::uint32_t> constructed_;
  std::uint32_t count_ = 0;
};

}  // namespace

FlowSolid flow_solid(const FlowGraph& graph, const PeelOptions& options, const Context& context) {
  if (options.ratio.sign() == Sign::negative || options.ratio > Rational(1))
    throw InputError("the ratio of distances must be in [0, 1]");
  const SaddlesOfEnds of(graph);
  FlowSolid solid;
  solid.is_inside.assign(graph.maxima().size(), true);
  std::vector<std::uint32_t> open{graph.infinity()};
  for (std::size_t steps = 1; !open.empty(); ++steps) {
    if (steps % 256 == 0) context.poll();
    const std::uint32_t at = open.back();
    open.pop_back();
    for (std::size_t i = of.begin[at]; i < of.begin[at + 1]; ++i) {
      const FlowGraph::Saddle& saddle = graph.saddles()[of.list[i]];
      const std::uint32_t behind = saddle.ends[0] == at ? saddle.ends[1] : saddle.ends[0];
      if (behind == graph.infinity() || !solid.is_inside[behind]) continue;
      if (!is_open(graph, of.list[i], behind, options.ratio)) continue;
      solid.is_inside[behind] = false;
      open.push_back(behind);
    }
  }
  solid.wall = wall_of(graph, solid.is_inside);
  return solid;
}

std::vector<WallSaddle> wall_of(const FlowGraph& graph, const std::vector<bool>& is_inside) {
  std::vector<WallSaddle> wall;
  for (const FlowGraph::Saddle& saddle : graph.saddles()) {
    const auto is_in = [&](std::uint32_t end) { return end != graph.infinity() && is_inside[end]; };
    const bool first = is_in(saddle.ends[0]);
    if (first != is_in(saddle.ends[1])) wall.push_back({saddle.facet, first});
  }
  return wall;
}

std::vector<WallSaddle> walls_between(const FlowGraph& graph, std::span<const std::uint32_t> becomes) {
  std::vector<WallSaddle> walls;
  for (const FlowGraph::Saddle& saddle : graph.saddles()) {
    const auto region = [&](std::uint32_t end) { return end == graph.infinity() ? end : becomes[end]; };
    const std::uint32_t first = region(saddle.ends[0]);
    const std::uint32_t second = region(saddle.ends[1]);
    if (first != second) walls.push_back({saddle.facet, first < second});
  }
  return walls;
}

FlowMesh flow_mesh(const FlowCells& flow, std::span<const WallSaddle> wall, const Context& context,
                   const FlowMeshOptions& options) {
  MeshMaker maker(flow, options);
  for (std::size_t i = 0; i < wall.size(); ++i) {
    if (i % 64 == 0) context.poll();
    maker.add(wall[i], context);
  }
  return maker.take();
}

}  // namespace quoin
