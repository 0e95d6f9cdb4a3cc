// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/convolution.h"

#include <span>
#include <vector>

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
    std::size_t count = 0;
    for (const ArcCrossing& x : crossings_) {
      if (++count % 1024 == 0) context_.poll();
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
    const auto own = [this](auto... edge) { return signs_.of_fixed_normal(edge...); };
    const auto other = [this](auto... edge) { return signs_.of_turned_normal(edge...); };
    const auto change = [this](const ArcCrossing& x) { return x.along_a * b_.edges()[x.b].sign; };
    const auto corner = [](std::uint32_t of_a, std::uint32_t of_b) { return PairMesh::Corner{of_a, of_b}; };
    add_tiles(a_, &ArcCrossing::a, b_, &ArcCrossing::b, own, other, change, corner);
  }

  void add_tiles_of_b() {
    const auto own = [this](auto... edge) { return signs_.of_turned_normal(edge...); };
    const auto other = [this](auto... edge) { return signs_.of_fixed_normal(edge...); };
    const auto change = [this](const ArcCrossing& x) { return -x.along_a * b_.edges()[x.b].sign; };
    const auto corner = [](std::uint32_t of_b, std::uint32_t of_a) { return PairMesh::Corner{of_a, of_b}; };
    add_tiles(b_, &ArcCrossing::b, a_, &ArcCrossing::a, own, other, change, corner);
  }

  /// Every tile of a surface at the vertices of the other one that are critical along its normal. `own` and `other`
  /// give signs of the normals of the one and of the other; `change` what a crossing does to the head of the other's
  /// edge, along the arc of the own one.
  template <class Own, class Other, class Change, class MakeCorner>
  void add_tiles(const TiledSurface& surface, std::uint32_t ArcCrossing::*own_edge, const TiledSurface& placed_at,
                 std::uint32_t ArcCrossing::*other_edge, const Own& own, const Other& other, const Change& change,
                 const MakeCorner& corner) {
    const CrossingsOfEdges by_edge(surface.edges().size(), crossings_, own_edge);
    CriticalVertices critical(placed_at);
    const auto start = [&](std::uint32_t tile) {
      const std::uint32_t path = 3 * tile;
      const Vector3 vector = vector_of(surface, path);
      critical.start([&](const TiledSurface::Edge& e) { return own(tile, e.tail, e.head, e.vector); },
                     [&](std::uint32_t t) { return other(t, surface.tail(path), surface.head(path), vector); });
    };
    const auto cross = [&](std::uint32_t halfedge) {
      const std::uint32_t edge = surface.edge_of(halfedge);
      const int way = surface.edges()[edge].halfedge == halfedge ? 1 : -1;
      for (const std::uint32_t i : by_edge.of(edge)) {
        critical.move(placed_at.edges()[crossings_[i].*other_edge], way * change(crossings_[i]));
      }
    };
    walk_tiles(surface, start, cross, [&](std::uint32_t tile) {
      const Tile& t = surface.tiles()[tile];
      for (const std::uint32_t v : critical.vertices())
        mesh_.add({corner(t[0], v), corner(t[1], v), corner(t[2], v)}, critical.count(v));
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
