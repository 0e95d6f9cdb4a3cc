// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/patch_certificate.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace quoin {

namespace {

constexpr std::size_t smallest_patch = 64;
constexpr std::size_t largest_patch = 65536;
constexpr std::size_t normal_samples = 16;
constexpr std::size_t tests_per_edge = 64;  // of a rim, before the patch is given up

// A halfedge of the rim, and its box in the plane of projection.
struct RimEdge {
  std::uint32_t from;
  std::uint32_t to;
  std::array<double, 2> lo;
  std::array<double, 2> hi;
};

// A closed box in the plane of projection.
struct LoopBox {
  std::array<double, 2> lo;
  std::array<double, 2> hi;
};

template <class A, class B>
bool are_apart(const A& a, const B& b) {
  return a.hi[0] < b.lo[0] || b.hi[0] < a.lo[0] || a.hi[1] < b.lo[1] || b.hi[1] < a.lo[1];
}

class PatchCertifier {
 public:
  PatchCertifier(const Leaf& leaf, const Constructions& points, std::span<const std::uint32_t> slots)
      : leaf_(leaf), points_(points), slots_(slots) {}

  bool is_patch(const BoxTree::Subtree& part) {
    choose_axis(part);
    return has_one_turn(part) && gather_rim(part) && is_simple() && are_loops_apart();
  }
  const std::vector<RimEdge>& rim() const { return rim_; }

 private:
  // The axis along which the sum of some normals is longest. Any will do; a good one succeeds more often.
  void choose_axis(const BoxTree::Subtree& part) {
    Vector3 sum{0, 0, 0};
    const std::size_t step = std::max<std::size_t>(1, part.tiles.size() / normal_samples);
    for (std::size_t i = 0; i < part.tiles.size(); i += step) {
      const Tile& tile = leaf_.tiles[part.tiles[i]];
      const Point3& p = leaf_.vertices[tile[0]];
      const Point3& q = leaf_.vertices[tile[1]];
      const Point3& r = leaf_.vertices[tile[2]];
      const Vector3 a{q.x - p.x, q.y - p.y, q.z - p.z};
      const Vector3 b{r.x - p.x, r.y - p.y, r.z - p.z};
      sum.x += a.y * b.z - a.z * b.y;
      sum.y += a.z * b.x - a.x * b.z;
      sum.z += a.x * b.y - a.y * b.x;
    }
    axis_ = 0;
    for (unsigned k = 1; k < 3; ++k) {
      if (std::fabs(sum[k]) > std::fabs(sum[axis_])) axis_ = k;
    }
    turn_ = sum[axis_] < 0 ? Sign::negative : Sign::positive;
  }

  bool has_one_turn(const BoxTree::Subtree& part) const {
    return std::all_of(part.tiles.begin(), part.tiles.end(), [&](std::uint32_t t) {
      const Tile& tile = leaf_.tiles[t];
      return turns_certainly(tile) || turn(tile[0], tile[1], tile[2]) == turn_;
    });
  }

  // Of two products of differences of doubles, each is off by less than 2^-51 of itself, and so is what is left of
  // both; above 1e-280 nothing that matters underflows.
  bool turns_certainly(const Tile& tile) const {
    if (!leaf_.exact_vertices.empty()) return false;
    const std::size_t u = (axis_ + 1) % 3;
    const std::size_t v = (axis_ + 2) % 3;
    const Point3& a = leaf_.vertices[tile[0]];
    const Point3& b = leaf_.vertices[tile[1]];
    const Point3& c = leaf_.vertices[tile[2]];
    const double left = (b[u] - a[u]) * (c[v] - a[v]);
    const double right = (b[v] - a[v]) * (c[u] - a[u]);
    const double size = std::fabs(left) + std::fabs(right);
    const double value = turn_ == Sign::positive ? left - right : right - left;
    return size > 1e-280 && value > 0x1p-50 * size;
  }

  Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return points_.turn(PointId{a}, PointId{b}, PointId{c}, axis_);
  }

  // False where some vertex has several rim edges that leave it. As many arrive as leave, so each has one of both.
  bool gather_rim(const BoxTree::Subtree& part) {
    for (const std::uint32_t t : part.tiles) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t twin = leaf_.twins[3 * t + k];
        if (twin != Leaf::no_twin && slots_[twin / 3] - part.begin < part.end - part.begin) continue;
        add_rim_edge(leaf_.tiles[t][k], leaf_.tiles[t][k == 2 ? 0 : k + 1]);
      }
    }
    for (const RimEdge& e : rim_) by_vertex_.push_back({e.from, e.to});
    std::sort(by_vertex_.begin(), by_vertex_.end());
    return std::adjacent_find(by_vertex_.begin(), by_vertex_.end(), [](const MeshEdge& a, const MeshEdge& b) {
             return a.from == b.from;
           }) == by_vertex_.end();
  }

  // Coordinates are rounded where the points are not doubles: boxes apart in them are apart.
  void add_rim_edge(std::uint32_t from, std::uint32_t to) {
    RimEdge e{from, to, {}, {}};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [lo, hi] = std::minmax({coordinate(from, k), coordinate(to, k)});
      e.lo[k] = lo;
      e.hi[k] = hi;
    }
    rim_.push_back(e);
  }

  double coordinate(std::uint32_t v, std::size_t k) const { return leaf_.vertices[v][(axis_ + 1 + k) % 3]; }

  // Whether rim edges meet in nothing but the vertex between two that follow each other.
  bool is_simple() {
    std::sort(rim_.begin(), rim_.end(), [](const RimEdge& a, const RimEdge& b) {
      return a.lo[0] != b.lo[0] ? a.lo[0] < b.lo[0] : a.from < b.from;
    });
    std::size_t tests = 0;
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      for (std::size_t j = i + 1; j < rim_.size() && rim_[j].lo[0] <= rim_[i].hi[0]; ++j) {
        if (++tests > tests_per_edge * rim_.size()) return false;
        if (!are_apart(rim_[i], rim_[j]) && !are_clear(rim_[i], rim_[j])) return false;
      }
    }
    return true;
  }

  bool are_clear(const RimEdge& a, const RimEdge& b) const {
    if (a.to == b.from) return go_on(a.from, a.to, b.to);
    if (b.to == a.from) return go_on(b.from, b.to, a.to);
    return is_beside(a, b) || is_beside(b, a);
  }

  // Whether the edge from q to r does not run back on that from p to q.
  bool go_on(std::uint32_t p, std::uint32_t q, std::uint32_t r) const {
    if (turn(p, q, r) != Sign::zero) return true;
    for (std::size_t k = 0; k < 2; ++k) {
      const double middle = coordinate(q, k);
      if (coordinate(p, k) < middle && middle < coordinate(r, k)) return true;
      if (coordinate(p, k) > middle && middle > coordinate(r, k)) return true;
    }
    return false;
  }

  // Whether one side of the line through b has all of a.
  bool is_beside(const RimEdge& a, const RimEdge& b) const {
    const Sign side = turn(b.from, b.to, a.from);
    return side != Sign::zero && turn(b.from, b.to, a.to) == side;
  }

  bool are_loops_apart() {
    std::vector<LoopBox> loops;
    std::vector<std::uint8_t> seen(by_vertex_.size(), 0);
    for (std::size_t first = 0; first < by_vertex_.size(); ++first) {
      if (seen[first] != 0) continue;
      const double u = coordinate(by_vertex_[first].from, 0);
      const double v = coordinate(by_vertex_[first].from, 1);
      LoopBox box{{u, v}, {u, v}};
      for (std::size_t at = first; seen[at] == 0; at = edge_from(by_vertex_[at].to)) {
        seen[at] = 1;
        for (std::size_t k = 0; k < 2; ++k) {
          box.lo[k] = std::min(box.lo[k], coordinate(by_vertex_[at].from, k));
          box.hi[k] = std::max(box.hi[k], coordinate(by_vertex_[at].from, k));
        }
      }
      if (loops.size() >= tests_per_edge) return false;
      for (const LoopBox& other : loops) {
        if (!are_apart(box, other)) return false;
      }
      loops.push_back(box);
    }
    return true;
  }

  std::size_t edge_from(std::uint32_t vertex) const {
    const auto at = std::lower_bound(by_vertex_.begin(), by_vertex_.end(), vertex,
                                     [](const MeshEdge& e, std::uint32_t v) { return e.from < v; });
    return static_cast<std::size_t>(at - by_vertex_.begin());
  }

  const Leaf& leaf_;
  const Constructions& points_;
  std::span<const std::uint32_t> slots_;
  unsigned axis_ = 0;
  Sign turn_ = Sign::positive;
  std::vector<RimEdge> rim_;
  std::vector<MeshEdge> by_vertex_;  // the rim by where its edges leave
};

}  // namespace

Patches find_patches(const Leaf& leaf, const Constructions& points, const Context& context) {
  const std::vector<std::uint32_t> slots = leaf.tree.slots();
  Patches patches;
  patches.is_seam.assign(leaf.vertices.size(), 0);
  const auto accept = [&](const BoxTree::Subtree& part) {
    PatchCertifier certifier(leaf, points, slots);
    if (!certifier.is_patch(part)) return false;
    for (const RimEdge& e : certifier.rim()) {  // from several threads, always the same value
      std::atomic_ref<std::uint8_t>(patches.is_seam[e.from]).store(1, std::memory_order_relaxed);
    }
    return true;
  };
  BoxTree::Marked marked = leaf.tree.marked_subtrees(smallest_patch, largest_patch, accept, context);
  for (const std::uint32_t t : marked.other_tiles) {
    for (const std::uint32_t v : leaf.tiles[t]) patches.is_seam[v] = 1;
  }
  patches.is_patch = std::move(marked.is_marked);
  return patches;
}

}  // namespace quoin
