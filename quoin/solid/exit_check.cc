// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/exit_check.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "quoin/base/parallel.h"
#include "quoin/solid/occupancy_grid.h"
#include "quoin/solid/overlay/contacts.h"

namespace quoin {

namespace {

class CrossingFinder {
 public:
  CrossingFinder(std::span<const Point3> vertices, std::span<const Tile> triangles, std::span<const std::uint8_t> moved,
                 const Context& context)
      : vertices_(vertices), triangles_(triangles), moved_(moved), context_(context) {}

  std::vector<TilePair> run() {
    gather_moved();
    if (moved_triangles_.empty()) return {};
    find_pairs();
    keep_crossing();
    return std::move(pairs_);
  }

 private:
  bool has_moved(const Tile& t) const { return (moved_[t[0]] | moved_[t[1]] | moved_[t[2]]) != 0; }

  void gather_moved() {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (!has_moved(triangles_[t])) continue;
      moved_triangles_.push_back(t);
      tiles_.push_back(triangles_[t]);
    }
    tree_ = BoxTree(vertices_, tiles_, context_);
  }

  // Moved against moved, each pair once, and against the others.
  void find_pairs() {
    for (const TilePair& pair : tree_.self_pairs(context_))
      pairs_.push_back({moved_triangles_[pair.a], moved_triangles_[pair.b]});
    const std::optional<OccupancyGrid> grid = make_grid();
    constexpr std::size_t grain = 8192;
    std::vector<std::vector<TilePair>> found(chunk_count(triangles_.size(), grain));
    for_each_chunk(context_, triangles_.size(), grain, [&](const Chunk& chunk) {
      std::vector<std::uint32_t> hits;
      for (auto t = static_cast<std::uint32_t>(chunk.begin); t < chunk.end; ++t) {
        if (has_moved(triangles_[t])) continue;
        if (grid && !grid->may_meet(box_of(vertices_, triangles_[t]))) continue;
        hits.clear();
        find_moved_near(triangles_[t], hits);
        for (const std::uint32_t h : hits) found[chunk.index].push_back({moved_triangles_[h], t});
      }
    });
    for (const auto& part : found) pairs_.insert(pairs_.end(), part.begin(), part.end());
  }

  // Pays where most triangles stayed in place and few boxes are large.
  std::optional<OccupancyGrid> make_grid() const {
    const std::size_t others = triangles_.size() - tiles_.size();
    if (others / 4 < tiles_.size()) return std::nullopt;
    std::optional<OccupancyGrid> grid{std::in_place, tree_.bounds()};
    std::size_t rows = 0;
    for (const Tile& tile : tiles_) {
      rows += grid->add(box_of(vertices_, tile));
      if (rows > 4 * others) return std::nullopt;
    }
    return grid;
  }

  void find_moved_near(const Tile& t, std::vector<std::uint32_t>& hits) const {
    Point3 lo = vertices_[t[0]];
    Point3 hi = lo;
    for (const std::uint32_t v : t) {
      for (std::size_t k = 0; k < 3; ++k) {
        lo[k] = std::min(lo[k], vertices_[v][k]);
        hi[k] = std::max(hi[k], vertices_[v][k]);
      }
    }
    tree_.tiles_in_box(lo, hi, hits);
  }

  // The points of the pairs alone make the table, so that its grid is not wider than need be.
  void keep_crossing() {
    point_of_.assign(vertices_.size(), PointId{});
    std::vector<Point3> points;
    const auto number = [&](const Tile& tile) {
      for (const std::uint32_t v : tile) {
        if (point_of_[v] != PointId{}) continue;
        point_of_[v] = PointId{points.size()};
        points.push_back(vertices_[v]);
      }
    };
    for (const Tile& t : tiles_) number(t);
    for (const TilePair& pair : pairs_) {
      number(triangles_[pair.a]);
      number(triangles_[pair.b]);
    }
    table_ = Constructions(std::move(points));
    constexpr std::size_t grain = 256;
    std::vector<std::vector<TilePair>> found(chunk_count(pairs_.size(), grain));
    for_each_chunk(context_, pairs_.size(), grain, [&](const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        if (cross(pairs_[i]))
          found[chunk.index].push_back({std::min(pairs_[i].a, pairs_[i].b), std::max(pairs_[i].a, pairs_[i].b)});
      }
    });
    pairs_.clear();
    add_flat_triangles();
    for (const auto& part : found) pairs_.insert(pairs_.end(), part.begin(), part.end());
    std::sort(pairs_.begin(), pairs_.end());
  }

  overlay::Corners corners(std::uint32_t t) const {
    const Tile& tile = triangles_[t];
    return {point_of_[tile[0]], point_of_[tile[1]], point_of_[tile[2]]};
  }

  bool is_flat(const overlay::Corners& c) const {
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (table_.turn(c[0], c[1], c[2], axis) != Sign::zero) return false;
    }
    return true;
  }

  void add_flat_triangles() {
    for (const std::uint32_t t : moved_triangles_) {
      if (is_flat(corners(t))) pairs_.push_back({t, t});
    }
  }

  bool cross(const TilePair& pair) const {
    const overlay::Corners a = corners(pair.a);
    const overlay::Corners b = corners(pair.b);
    if (overlay::have_equal_corners(table_, a, b)) return true;
    if (overlay::have_same_corners(a, b)) return true;
    if (overlay::are_separated(table_, a, b)) return false;
    if (is_flat(a) || is_flat(b)) return false;  // listed by itself
    return overlay::have_contacts(table_, a, b);
  }

  std::span<const Point3> vertices_;
  std::span<const Tile> triangles_;
  std::span<const std::uint8_t> moved_;
  const Context& context_;
  std::vector<std::uint32_t> moved_triangles_;
  std::vector<Tile> tiles_;  // those
  BoxTree tree_;             // of those
  std::vector<TilePair> pairs_;
  Constructions table_{std::vector<Point3>{}};
  std::vector<PointId> point_of_;  // per vertex that occurs in a pair
};

}  // namespace

std::vector<TilePair> find_crossings(std::span<const Point3> vertices, std::span<const Tile> triangles,
                                     std::span<const std::uint8_t> moved, const Context& context) {
  return CrossingFinder(vertices, triangles, moved, context).run();
}

}  // namespace quoin
