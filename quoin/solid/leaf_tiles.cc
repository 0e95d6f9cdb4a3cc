// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/leaf_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <queue>
#include <utility>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/error.h"
#include "quoin/triangulation/polygon.h"

namespace quoin {

namespace {

bool are_collinear(const Constructions& points, PointId a, PointId b, PointId c) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (points.turn(a, b, c, axis) != Sign::zero) return false;
  }
  return true;
}

class TileMaker {
 public:
  TileMaker(const Mesh& mesh, const Constructions& points, std::size_t max_listed, MeshDiagnosis& diagnosis,
            const Context& context)
      : mesh_(mesh), points_(points), max_listed_(max_listed), diagnosis_(diagnosis), context_(context) {}

  MeshTiles run() {
    const std::size_t tiles = mesh_.corners.size() - std::min(mesh_.corners.size(), 2 * mesh_.face_count());
    out_.tiles.reserve(tiles);
    out_.tile_face.reserve(tiles);
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      if (f % 1024 == 0) context_.poll();
      add_face(f);
    }
    if (!slivers_.empty()) heal_slivers();
    return std::move(out_);
  }

 private:
  void add_face(std::uint32_t face) {
    const auto corners = mesh_.face(face);
    for (const std::uint32_t v : corners) {
      if (v >= mesh_.vertices.size())
        throw InputError("face " + std::to_string(face) + ": vertex " + std::to_string(v) + " is not there");
    }
    if (corners.size() == 3) {
      add_triangle(face, {corners[0], corners[1], corners[2]});
      return;
    }
    loop_.clear();
    for (const std::uint32_t v : corners) {
      if (loop_.empty() || loop_.back() != v) loop_.push_back(v);
    }
    while (loop_.size() > 1 && loop_.front() == loop_.back()) loop_.pop_back();
    if (loop_.size() != corners.size() || loop_.size() < 3) note(diagnosis_.degenerate_faces, face, max_listed_);
    if (loop_.size() < 3) return;
    add_polygon(face);
  }

  void add_triangle(std::uint32_t face, const Tile& t) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      note(diagnosis_.degenerate_faces, face, max_listed_);
      return;
    }
    if (are_collinear(points_, PointId{t[0]}, PointId{t[1]}, PointId{t[2]})) {
      note(diagnosis_.degenerate_faces, face, max_listed_);
      slivers_.push_back({t, face});
      return;
    }
    out_.tiles.push_back(t);
    out_.tile_face.push_back(face);
  }

  void add_polygon(std::uint32_t face) {
    if (!is_planar()) note(diagnosis_.not_planar_faces, face, max_listed_);
    for (const auto& [u, v] : projections()) {
      if (triangulate_projected(face, u, v)) return;
    }
    note(diagnosis_.not_simple_faces, face, max_listed_);
    // A fan closes the surface all the same; where it folds over, winding numbers tell.
    for (std::size_t i = 2; i < loop_.size(); ++i) {
      const Tile t{loop_[0], loop_[i - 1], loop_[i]};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) add_triangle(face, t);
    }
  }

  bool is_planar() const {
    std::size_t third = 2;
    while (third < loop_.size() && are_collinear(points_, PointId{loop_[0]}, PointId{loop_[1]}, PointId{loop_[third]}))
      ++third;
    if (third == loop_.size()) return true;
    return std::all_of(loop_.begin(), loop_.end(), [&](std::uint32_t v) {
      return points_.orientation(PointId{loop_[0]}, PointId{loop_[1]}, PointId{loop_[third]}, PointId{v}) == Sign::zero;
    });
  }

  bool triangulate_projected(std::uint32_t face, unsigned u, unsigned v) {
    polygon_points_.clear();
    polygon_loop_.clear();
    for (std::uint32_t i = 0; i < loop_.size(); ++i) {
      const Point3& p = points_.rounded(PointId{loop_[i]});
      polygon_points_.push_back({p[u], p[v]});
      polygon_loop_.push_back(i);
    }
    triangles_.clear();
    const std::array<std::uint32_t, 2> begin{0, static_cast<std::uint32_t>(loop_.size())};
    if (!triangulate_polygon(polygon_points_, polygon_loop_, begin, triangles_)) return false;
    for (const PolygonTriangle& t : triangles_) add_triangle(face, {loop_[t[0]], loop_[t[1]], loop_[t[2]]});
    return true;
  }

  // Pairs of coordinates to try, the largest area first as far as doubles tell, each in both orders: a triangulation
  // decides exactly whether the outline is a counterclockwise polygon there.
  std::array<std::array<unsigned, 2>, 6> projections() const {
    std::array<double, 3> area{};
    const Point3& origin = points_.rounded(PointId{loop_[0]});
    for (std::size_t i = 2; i < loop_.size(); ++i) {
      const Point3& p = points_.rounded(PointId{loop_[i - 1]});
      const Point3& q = points_.rounded(PointId{loop_[i]});
      for (unsigned axis = 0; axis < 3; ++axis) {
        const unsigned u = (axis + 1) % 3;
        const unsigned v = (axis + 2) % 3;
        area[axis] += (p[u] - origin[u]) * (q[v] - origin[v]) - (p[v] - origin[v]) * (q[u] - origin[u]);
      }
    }
    std::array<unsigned, 3> order{0, 1, 2};
    if (std::fabs(area[order[0]]) < std::fabs(area[order[1]])) std::swap(order[0], order[1]);
    if (std::fabs(area[order[0]]) < std::fabs(area[order[2]])) std::swap(order[0], order[2]);
    if (std::fabs(area[order[1]]) < std::fabs(area[order[2]])) std::swap(order[1], order[2]);
    std::array<std::array<unsigned, 2>, 6> result{};
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned u = (order[k] + 1) % 3;
      const unsigned v = (order[k] + 2) % 3;
      const bool is_negative = area[order[k]] < 0;
      result[2 * k] = is_negative ? std::array{v, u} : std::array{u, v};
      result[2 * k + 1] = is_negative ? std::array{u, v} : std::array{v, u};
    }
    return result;
  }

  struct Sliver {
    Tile tile;
    std::uint32_t face;
  };

  // A sliver with two corners in one place is an edge: its two vertices become one, for all faces.
  void join_equal_corners() {
    DisjointSets vertices(mesh_.vertices.size());
    bool any = false;
    for (const Sliver& sliver : slivers_) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = sliver.tile[k];
        const std::uint32_t b = sliver.tile[(k + 1) % 3];
        if (!points_.equal(PointId{a}, PointId{b})) continue;
        vertices.unite(a, b);
        any = true;
      }
    }
    if (!any) return;
    for (Tile& t : out_.tiles) {
      for (std::uint32_t& v : t) v = vertices.find(v);
    }
    for (Sliver& sliver : slivers_) {
      for (std::uint32_t& v : sliver.tile) v = vertices.find(v);
    }
    std::erase_if(slivers_, [](const Sliver& s) {
      return s.tile[0] == s.tile[1] || s.tile[1] == s.tile[2] || s.tile[2] == s.tile[0];
    });
  }

  // A triangle a, b, c with b between a and c is dropped; the tile on the other side of its long edge is split at b
  // instead, so that edges stay matched. That tile may be a sliver too. The longest sliver comes first, so that such a
  // neighbour lies between a and c and leaves two that are shorter: the number of steps is finite.
  void heal_slivers() {
    join_equal_corners();
    rank_vertices();
    for (std::uint32_t t = 0; t < out_.tiles.size(); ++t) index_tile(t);
    std::vector<Sliver> slivers;
    slivers.swap(slivers_);
    for (const Sliver& s : slivers) add_sliver(s.tile, s.face);
    for (std::size_t step = 0; !longest_slivers_.empty(); ++step) {
      if (step % 256 == 0) context_.poll();
      const std::uint32_t s = longest_slivers_.top().second;
      longest_slivers_.pop();
      if (!sliver_alive_[s]) continue;
      sliver_alive_[s] = false;
      const Tile t = slivers_[s].tile;
      const std::size_t k = middle_corner(t);
      split_opposite(t[(k + 2) % 3], t[(k + 1) % 3], t[k]);
    }
  }

  // The order of all points by x, y, z is on any line the order along it: of two slivers on a line, one within the
  // other spans no more ranks.
  void rank_vertices() {
    std::vector<std::uint32_t> order;
    for (const Sliver& s : slivers_) order.insert(order.end(), s.tile.begin(), s.tile.end());
    std::ranges::sort(order);
    order.erase(std::unique(order.begin(), order.end()), order.end());
    std::ranges::sort(order, [&](std::uint32_t p, std::uint32_t q) {
      const Sign sign = points_.compare_lexicographically(PointId{p}, PointId{q});
      return sign == Sign::zero ? p < q : sign == Sign::negative;
    });
    rank_.resize(mesh_.vertices.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) rank_[order[i]] = i;
  }

  void index_tile(std::uint32_t t) {
    for (std::size_t k = 0; k < 3; ++k) tile_at_[{out_.tiles[t][k], out_.tiles[t][(k + 1) % 3]}].push_back(t);
  }

  std::size_t middle_corner(const Tile& t) const {
    for (std::size_t k = 0; k < 2; ++k) {
      const bool is_after = rank_[t[k]] > rank_[t[(k + 1) % 3]];
      if (is_after != (rank_[t[k]] > rank_[t[(k + 2) % 3]])) return k;
    }
    return 2;
  }

  // The sliver had the edge c -> a and the middle b; its neighbour there runs a -> c.
  void split_opposite(std::uint32_t a, std::uint32_t c, std::uint32_t b) {
    const auto tiles = tile_at_.find({a, c});
    if (tiles != tile_at_.end()) {
      for (const std::uint32_t t : tiles->second) {
        const auto k = edge_of(out_.tiles[t], a, c);
        if (!k) continue;  // split meanwhile
        const std::uint32_t apex = out_.tiles[t][(*k + 2) % 3];
        out_.tiles[t] = {a, b, apex};
        out_.tiles.push_back({b, c, apex});
        out_.tile_face.push_back(out_.tile_face[t]);
        index_tile(t);
        index_tile(static_cast<std::uint32_t>(out_.tiles.size() - 1));
        return;
      }
    }
    const auto slivers = sliver_at_.find({a, c});
    if (slivers == sliver_at_.end()) return;
    for (const std::uint32_t s : slivers->second) {
      const auto k = sliver_alive_[s] ? edge_of(slivers_[s].tile, a, c) : std::nullopt;
      if (!k) continue;
      const std::uint32_t apex = slivers_[s].tile[(*k + 2) % 3];
      sliver_alive_[s] = false;
      if (apex == b) return;  // the two cancel
      add_sliver({a, b, apex}, slivers_[s].face);
      add_sliver({b, c, apex}, slivers_[s].face);
      return;
    }
  }

  void add_sliver(const Tile& t, std::uint32_t face) {
    const auto s = static_cast<std::uint32_t>(slivers_.size());
    slivers_.push_back({t, face});
    sliver_alive_.push_back(true);
    for (std::size_t k = 0; k < 3; ++k) sliver_at_[{t[k], t[(k + 1) % 3]}].push_back(s);
    const auto [first, last] = std::minmax({rank_[t[0]], rank_[t[1]], rank_[t[2]]});
    longest_slivers_.emplace(last - first, s);
  }

  static std::optional<std::size_t> edge_of(const Tile& t, std::uint32_t a, std::uint32_t c) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] == a && t[(k + 1) % 3] == c) return k;
    }
    return std::nullopt;
  }

  const Mesh& mesh_;
  const Constructions& points_;
  std::size_t max_listed_;
  MeshDiagnosis& diagnosis_;
  const Context& context_;
  MeshTiles out_;
  std::vector<Sliver> slivers_;
  std::vector<bool> sliver_alive_;
  std::vector<std::uint32_t> rank_;                                                        // of the vertices of slivers
  std::priority_queue<std::pair<std::uint32_t, std::uint32_t>> longest_slivers_;           // ranks spanned, sliver
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> tile_at_;  // by directed edge
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> sliver_at_;
  std::vector<std::uint32_t> loop_;
  std::vector<Point2> polygon_points_;
  std::vector<std::uint32_t> polygon_loop_;
  std::vector<PolygonTriangle> triangles_;
};

}  // namespace

MeshTiles make_tiles(const Mesh& mesh, const Constructions& points, std::size_t max_listed, MeshDiagnosis& diagnosis,
                     const Context& context) {
  return TileMaker(mesh, points, max_listed, diagnosis, context).run();
}

}  // namespace quoin
