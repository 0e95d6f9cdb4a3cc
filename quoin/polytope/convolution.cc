// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/convolution.h"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/polytope/arc_crossings.h"
#include "quoin/polytope/critical_vertices.h"
#include "quoin/polytope/pair_mesh.h"

namespace quoin {

namespace {

/// Numbers of crossings, by the edges of one of the two surfaces.
struct CrossingsOfEdges {
  CrossingsOfEdges(std::size_t edge_count, std::span<const ArcCrossing> crossings, std::uint32_t ArcCrossing::*edge)
      : first(edge_count + 1, 0), order(crossings.size()) {
    for (const ArcCrossing& x : crossings) ++first[x.*edge + 1];
    for (std::size_t e = 0; e < edge_count; ++e) first[e + 1] += first[e];
    std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
    for (std::uint32_t i = 0; i < crossings.size(); ++i) order[fill[crossings[i].*edge]++] = i;
  }
  std::span<const std::uint32_t> of(std::uint32_t edge) const {
    return {order.data() + first[edge], order.data() + first[edge + 1]};
  }
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> order;
};

class Convolver {
 public:
  Convolver(const TiledSurface& a, const TiledSurface& b, const Context& context)
      : a_(a), b_(b), context_(context), signs_(a, b) {}

  std::shared_ptr<const Leaf> run() {
    context_.progress("crossings of arcs", 0);
    crossings_ = arc_crossings(a_, b_, signs_, context_);
    context_.progress("convolution", 0);
    add_parallelograms();
    add_tiles_of_a();
    add_tiles_of_b();
    return mesh_.leaf(a_, b_, context_);
  }

 private:
  void add_parallelograms() {
    for (const ArcCrossing& x : crossings_) {
      const TiledSurface::Edge& e = a_.edges()[x.a];
      const TiledSurface::Edge& f = b_.edges()[x.b];
      const PairMesh::Corner start{e.tail, f.tail};
      const PairMesh::Corner on_a{e.head, f.tail};
      const PairMesh::Corner far{e.head, f.head};
      const PairMesh::Corner on_b{e.tail, f.head};
      const int turn = -f.sign * x.along_a;
      mesh_.add({start, on_a, far}, turn);
      mesh_.add({start, far, on_b}, turn);
    }
  }

  void add_tiles_of_a() {
    const CrossingsOfEdges by_edge(a_.edges().size(), crossings_, &ArcCrossing::a);
    CriticalVertices critical(b_);
    const auto start = [&](std::uint32_t tile) {
      const std::uint32_t tail = a_.tail(3 * tile);
      const std::uint32_t head = a_.head(3 * tile);
      const Vector3 path = vector_of(a_, 3 * tile);
      const auto height = [&](const TiledSurface::Edge& f) {
        return signs_.of_fixed_normal(tile, f.tail, f.head, f.vector);
      };
      const auto side_of_path = [&](std::uint32_t tile_of_b) {
        return signs_.of_turned_normal(tile_of_b, tail, head, path);
      };
      critical.start(height, side_of_path);
    };
    const auto cross = [&](std::uint32_t halfedge) {
      const std::uint32_t edge = a_.edge_of(halfedge);
      const int way = a_.edges()[edge].halfedge == halfedge ? 1 : -1;
      for (const std::uint32_t i : by_edge.of(edge)) {
        const TiledSurface::Edge& f = b_.edges()[crossings_[i].b];
        critical.move(f, way * crossings_[i].along_a * f.sign);
      }
    };
    walk_tiles(a_, start, cross, [&](std::uint32_t tile) {
      const Tile& t = a_.tiles()[tile];
      for (const std::uint32_t v : critical.vertices())
        mesh_.add({{{t[0], v}, {t[1], v}, {t[2], v}}}, critical.count(v));
    });
  }

  void add_tiles_of_b() {
    const CrossingsOfEdges by_edge(b_.edges().size(), crossings_, &ArcCrossing::b);
    CriticalVertices critical(a_);
    const auto start = [&](std::uint32_t tile) {
      const std::uint32_t tail = b_.tail(3 * tile);
      const std::uint32_t head = b_.head(3 * tile);
      const Vector3 path = vector_of(b_, 3 * tile);
      const auto height = [&](const TiledSurface::Edge& e) {
        return signs_.of_turned_normal(tile, e.tail, e.head, e.vector);
      };
      const auto side_of_path = [&](std::uint32_t tile_of_a) {
        return signs_.of_fixed_normal(tile_of_a, tail, head, path);
      };
      critical.start(height, side_of_path);
    };
    const auto cross = [&](std::uint32_t halfedge) {
      const std::uint32_t edge = b_.edge_of(halfedge);
      const int way = b_.edges()[edge].halfedge == halfedge ? 1 : -1;
      for (const std::uint32_t i : by_edge.of(edge)) {
        const TiledSurface::Edge& e = a_.edges()[crossings_[i].a];
        critical.move(e, -way * crossings_[i].along_a * b_.edges()[edge].sign);
      }
    };
    walk_tiles(b_, start, cross, [&](std::uint32_t tile) {
      const Tile& t = b_.tiles()[tile];
      for (const std::uint32_t v : critical.vertices())
        mesh_.add({{{v, t[0]}, {v, t[1]}, {v, t[2]}}}, critical.count(v));
    });
  }

  static Vector3 vector_of(const TiledSurface& surface, std::uint32_t halfedge) {
    const TiledSurface::Edge& e = surface.edges()[surface.edge_of(halfedge)];
    return e.halfedge == halfedge ? e.vector : Vector3{-e.vector.x, -e.vector.y, -e.vector.z};
  }

  /// Visits all tiles, depth first across edges: from tile to tile, and back the same way.
  template <class Start, class Cross, class Visit>
  void walk_tiles(const TiledSurface& surface, const Start& start, const Cross& cross, const Visit& visit) {
    std::vector<bool> is_seen(surface.tiles().size(), false);
    std::vector<std::uint32_t> path;  // halfedges to try next, 3 per tile that it leads through
    for (std::uint32_t root = 0; root < surface.tiles().size(); ++root) {
      if (is_seen[root]) continue;
      start(root);
      is_seen[root] = true;
      visit(root);
      walk_from(root, surface, is_seen, cross, visit);
    }
  }

  template <class Cross, class Visit>
  void walk_from(std::uint32_t root, const TiledSurface& surface, std::vector<bool>& is_seen, const Cross& cross,
                 const Visit& visit) {
    struct Step {
      std::uint32_t tile;
      std::uint32_t entered;  // halfedge of this tile
      std::uint32_t next;     // 0, 1, 2, 3
    };
    std::vector<Step> path{{root, none, 0}};
    while (!path.empty()) {
      Step& step = path.back();
      if (step.next == 3) {
        const std::uint32_t back = step.entered;
        path.pop_back();
        if (back != none) cross(back);
        continue;
      }
      const std::uint32_t halfedge = 3 * step.tile + step.next++;
      const std::uint32_t twin = surface.twin(halfedge);
      const std::uint32_t tile = TiledSurface::tile_of(twin);
      if (is_seen[tile]) continue;
      context_.poll();
      is_seen[tile] = true;
      cross(halfedge);
      visit(tile);
      path.push_back({tile, twin, 0});
    }
  }

  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  const TiledSurface& a_;
  const TiledSurface& b_;
  const Context& context_;
  SurfaceSigns signs_;
  std::vector<ArcCrossing> crossings_;
  PairMesh mesh_;
};

}  // namespace

std::shared_ptr<const Leaf> convolution(const TiledSurface& a, const TiledSurface& b, const Context& context) {
  return Convolver(a, b, context).run();
}

}  // namespace quoin
