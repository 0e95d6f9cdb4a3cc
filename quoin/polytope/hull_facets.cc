// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull_facets.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>
#include <utility>
#include <vector>

#include "quoin/base/large_vector.h"
#include "quoin/base/parallel.h"

namespace quoin {

namespace {

constexpr std::size_t grain = 16384;

class FacetJoiner {
 public:
  FacetJoiner(HullBuilder& builder, std::span<const std::uint32_t> names, std::size_t name_count,
              const Context& context)
      : builder_(builder),
        triangles_(builder.triangles()),
        names_(names),
        name_count_(name_count),
        context_(context),
        edges_(triangles_.size(), 0) {}

  ConvexHull join() {
    find_flat_edges();
    builder_.drop_planes();
    if (has_flat_edges_) count_rims();
    put_in_order(triangular_facets());
    if (!has_flat_edges_) {
      builder_.drop_triangles();
      triangles_ = {};
    }
    ConvexHull hull;
    hull.dimension = 3;
    write_corners(hull);
    return hull;
  }

 private:
  /// From its smallest corner on. The first two order all facets, as an edge runs along one facet in one direction.
  struct Facet {
    std::uint32_t first;
    std::uint32_t second;
    std::uint32_t rest;  // the third corner, if no edge is flat; else the triangle that has the first edge
  };
  struct Edge {
    std::uint32_t triangle;
    unsigned index;
    friend bool operator==(const Edge&, const Edge&) = default;
  };
  static constexpr std::uint8_t all_flat = 7;
  static constexpr std::uint8_t free_place = 64;
  static std::uint8_t flat(unsigned k) { return static_cast<std::uint8_t>(1U << k); }
  static std::uint8_t done(unsigned k) { return static_cast<std::uint8_t>(8U << k); }
  static unsigned next(unsigned k) { return k == 2 ? 0 : k + 1; }
  unsigned index_in(std::uint32_t triangle, std::uint32_t neighbour) const {
    const auto& across = triangles_[triangle].across;
    return across[0] == neighbour ? 0 : across[1] == neighbour ? 1 : 2;
  }
  std::uint32_t corner(const Edge& e) const { return triangles_[e.triangle].corners[e.index]; }
  /// Where only two edges that are not flat meet, one goes straight on.
  bool is_vertex(std::uint32_t point) const { return !has_flat_edges_ || rims_[point] > 2; }

  void find_flat_edges();
  void count_rims();
  UnsetVector<Facet> triangular_facets() const;
  void append_polygons(UnsetVector<Facet>& facets);
  void put_in_order(UnsetVector<Facet> facets);
  void write_corners(ConvexHull& hull) const;
  Facet triangle_facet(std::uint32_t t) const;
  Edge next_of_facet(Edge edge) const;
  template <class Visit>
  void for_each_vertex(const Facet& facet, const Visit& visit) const;

  HullBuilder& builder_;
  std::span<const HullBuilder::Triangle> triangles_;
  std::span<const std::uint32_t> names_;
  std::size_t name_count_;
  const Context& context_;
  std::vector<std::uint8_t> edges_;  // by triangle: which are flat, which belong to a facet already
  bool has_flat_edges_ = false;
  std::vector<std::uint32_t> rims_;  // by point: edges that are not flat; if any is
  UnsetVector<Facet> facets_;        // in order
};

/// Each from the one of its two triangles that comes first; so flags of a triangle are set from several threads.
void FacetJoiner::find_flat_edges() {
  std::atomic<bool> has_any{false};
  const auto set = [&](std::uint32_t t, std::uint8_t flag) {
    std::atomic_ref(edges_[t]).fetch_or(flag, std::memory_order_relaxed);
  };
  for_each_chunk(context_, triangles_.size(), grain, [&](const Chunk& chunk) {
    for (auto t = static_cast<std::uint32_t>(chunk.begin); t < chunk.end; ++t) {
      const HullBuilder::Triangle& triangle = triangles_[t];
      if (triangle.is_free()) {
        set(t, free_place);
        continue;
      }
      for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t across = triangle.across[k];
        if (across < t) continue;
        const unsigned back = index_in(across, t);
        if (builder_.side(t, triangles_[across].corners[next(next(back))]) != Sign::zero) continue;
        set(t, flat(k));
        set(across, flat(back));
        has_any.store(true, std::memory_order_relaxed);
      }
    }
  });
  has_flat_edges_ = has_any;
}

void FacetJoiner::count_rims() {
  rims_.assign(names_.size(), 0);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    if (t % 4096 == 0) context_.poll();
    if ((edges_[t] & free_place) != 0) continue;
    const HullBuilder::Triangle& triangle = triangles_[t];
    for (unsigned k = 0; k < 3; ++k) {
      if (triangle.across[k] < t || (edges_[t] & flat(k)) != 0) continue;
      ++rims_[triangle.corners[k]];
      ++rims_[triangle.corners[next(k)]];
    }
  }
}

FacetJoiner::Edge FacetJoiner::next_of_facet(Edge edge) const {
  edge.index = next(edge.index);
  while ((edges_[edge.triangle] & flat(edge.index)) != 0) {
    const std::uint32_t across = triangles_[edge.triangle].across[edge.index];
    edge = {across, next(index_in(across, edge.triangle))};
  }
  return edge;
}

template <class Visit>
void FacetJoiner::for_each_vertex(const Facet& facet, const Visit& visit) const {
  if (!has_flat_edges_) {
    visit(facet.first);
    visit(facet.second);
    visit(facet.rest);
    return;
  }
  unsigned k = 0;
  while (names_[triangles_[facet.rest].corners[k]] != facet.first) ++k;
  const Edge begin{facet.rest, k};
  Edge edge = begin;
  do {
    if (is_vertex(corner(edge))) visit(names_[corner(edge)]);
    edge = next_of_facet(edge);
  } while (edge != begin);
}

FacetJoiner::Facet FacetJoiner::triangle_facet(std::uint32_t t) const {
  const auto& corners = triangles_[t].corners;
  const std::array<std::uint32_t, 3> n{names_[corners[0]], names_[corners[1]], names_[corners[2]]};
  const unsigned k = n[0] < n[1] ? (n[0] < n[2] ? 0 : 2) : (n[1] < n[2] ? 1 : 2);
  return {n[k], n[next(k)], has_flat_edges_ ? t : n[next(next(k))]};
}

/// In any order.
UnsetVector<FacetJoiner::Facet> FacetJoiner::triangular_facets() const {
  const auto is_triangle = [&](std::size_t t) { return (edges_[t] & (all_flat | free_place)) == 0; };
  std::vector<std::size_t> places(chunk_count(triangles_.size(), grain));
  for_each_chunk(context_, triangles_.size(), grain, [&](const Chunk& chunk) {
    std::size_t count = 0;
    for (std::size_t t = chunk.begin; t < chunk.end; ++t) count += static_cast<std::size_t>(is_triangle(t));
    places[chunk.index] = count;
  });
  std::size_t total = 0;
  for (std::size_t& place : places) total += std::exchange(place, total);
  UnsetVector<Facet> result(total);
  for_each_chunk(context_, triangles_.size(), grain, [&](const Chunk& chunk) {
    std::size_t place = places[chunk.index];
    for (std::size_t t = chunk.begin; t < chunk.end; ++t) {
      if (is_triangle(t)) result[place++] = triangle_facet(static_cast<std::uint32_t>(t));
    }
  });
  return result;
}

/// Those of several triangles.
void FacetJoiner::append_polygons(UnsetVector<Facet>& facets) {
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    if (t % 4096 == 0) context_.poll();
    if ((edges_[t] & all_flat) == 0) continue;
    for (unsigned k = 0; k < 3; ++k) {
      Facet facet{0xFFFFFFFFU, 0, t};
      std::uint32_t first_seen = 0xFFFFFFFFU;
      bool second_follows = false;
      for (Edge edge{t, k}; (edges_[edge.triangle] & (flat(edge.index) | done(edge.index))) == 0;
           edge = next_of_facet(edge)) {
        edges_[edge.triangle] |= done(edge.index);
        if (!is_vertex(corner(edge))) continue;
        const std::uint32_t name = names_[corner(edge)];
        if (first_seen == 0xFFFFFFFFU) first_seen = name;
        if (second_follows) facet.second = name;
        second_follows = name < facet.first;
        if (second_follows) facet = {name, 0, edge.triangle};
      }
      if (second_follows) facet.second = first_seen;
      if (first_seen != 0xFFFFFFFFU) facets.push_back(facet);
    }
  }
}

/// By counting, each thread for a range of first corners that as many facets have, roughly; then by the second corner.
void FacetJoiner::put_in_order(UnsetVector<Facet> facets) {
  if (has_flat_edges_) append_polygons(facets);
  std::vector<std::uint32_t> sample;
  for (std::size_t f = 0; f < facets.size(); f += facets.size() / 1024 + 1) sample.push_back(facets[f].first);
  std::sort(sample.begin(), sample.end());
  const std::size_t parts = std::clamp<std::size_t>(facets.size() / grain, 1, context_.threads());
  std::vector<std::size_t> bounds(parts + 1, 0);
  for (std::size_t p = 1; p < parts; ++p) bounds[p] = sample[sample.size() * p / parts];
  bounds[parts] = name_count_;
  // Of each name: how many facets it begins, then where the next of them goes.
  UnsetVector<std::uint32_t> places(name_count_);
  std::vector<std::size_t> totals(parts + 1, 0);
  for_each_chunk(context_, parts, 1, [&](const Chunk& part) {
    const std::size_t low = bounds[part.index];
    const std::size_t high = bounds[part.index + 1];
    std::fill(places.data() + low, places.data() + high, 0U);
    for (const Facet& f : facets) {
      if (f.first >= low && f.first < high) ++places[f.first];
    }
    std::uint32_t total = 0;
    for (std::size_t name = low; name < high; ++name) total += std::exchange(places[name], total);
    totals[part.index + 1] = total;
  });
  std::partial_sum(totals.begin(), totals.end(), totals.begin());
  facets_.resize(facets.size());
  for_each_chunk(context_, parts, 1, [&](const Chunk& part) {
    const std::size_t low = bounds[part.index];
    const std::size_t high = bounds[part.index + 1];
    Facet* const begin = facets_.data() + totals[part.index];
    for (const Facet& f : facets) {
      if (f.first >= low && f.first < high) begin[places[f.first]++] = f;
    }
    const Facet* const end = facets_.data() + totals[part.index + 1];
    for (Facet* run = begin; run != end;) {
      Facet* after = run + 1;
      while (after != end && after->first == run->first) ++after;
      if (after - run > 1) std::sort(run, after, [](const Facet& a, const Facet& b) { return a.second < b.second; });
      run = after;
    }
  });
}

void FacetJoiner::write_corners(ConvexHull& hull) const {
  hull.facet_begin.assign(facets_.size() + 1, 0);
  for_each_chunk(context_, facets_.size(), grain, [&](const Chunk& chunk) {
    for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
      std::size_t size = 0;
      if (has_flat_edges_) for_each_vertex(facets_[f], [&](std::uint32_t) { ++size; });
      hull.facet_begin[f + 1] = has_flat_edges_ ? size : 3 * (f + 1);
    }
  });
  if (has_flat_edges_) std::partial_sum(hull.facet_begin.begin(), hull.facet_begin.end(), hull.facet_begin.begin());
  hull.corners.resize(hull.facet_begin.back());
  std::vector<std::uint8_t> is_name(name_count_, 0);
  for_each_chunk(context_, facets_.size(), grain, [&](const Chunk& chunk) {
    for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
      std::size_t place = hull.facet_begin[f];
      for_each_vertex(facets_[f], [&](std::uint32_t name) {
        hull.corners[place++] = name;
        std::atomic_ref(is_name[name]).store(1, std::memory_order_relaxed);
      });
    }
  });
  hull.vertices.reserve(static_cast<std::size_t>(std::count(is_name.begin(), is_name.end(), 1)));
  for (std::uint32_t v = 0; v < name_count_; ++v) {
    if (is_name[v] != 0) hull.vertices.push_back(v);
  }
}

}  // namespace

ConvexHull join_facets(HullBuilder& builder, std::span<const std::uint32_t> names, std::size_t name_count,
                       const Context& context) {
  return FacetJoiner(builder, names, name_count, context).join();
}

ConvexHull hull_of_polygon(std::span<const std::uint32_t> corners) {
  ConvexHull hull;
  hull.dimension = 2;
  hull.corners.assign(corners.begin(), corners.end());
  std::rotate(hull.corners.begin(), std::min_element(hull.corners.begin(), hull.corners.end()), hull.corners.end());
  hull.facet_begin.push_back(hull.corners.size());
  hull.vertices = hull.corners;
  std::sort(hull.vertices.begin(), hull.vertices.end());
  return hull;
}

ConvexHull hull_in_plane(std::span<const std::uint32_t> corners) {
  ConvexHull hull;
  hull.dimension = corners.size() > 2 ? 2 : static_cast<int>(corners.size()) - 1;
  hull.vertices.assign(corners.begin(), corners.end());
  std::sort(hull.vertices.begin(), hull.vertices.end());
  if (hull.dimension < 2) return hull;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    hull.corners.insert(hull.corners.end(), {corners[i], corners[(i + 1) % corners.size()]});
    hull.facet_begin.push_back(hull.corners.size());
  }
  return hull;
}

}  // namespace quoin
