// SPDX-License-Identifier: Apache-2.0
//
// Bounds are those of TileEdges. The planar product w . e of two terms, one difference and one product in each and a
// sum: below 2 (2 u) + 2 u = 6 u |w| |e| with the largest components and u = 2^-53; the third term is zero.
#include "quoin/solid/star_certificate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "quoin/kernel/order.h"
#include "quoin/solid/tile_edges.h"

namespace quoin {

namespace {

Vector3 minus(const Vector3& a) {
  return {-a.x, -a.y, -a.z};
}

// How the star of a vertex is looked at: along d, the sum of its normals, counting passes of the half-line in the plane
// w . e = 0, where w is the product of d with the axis least aligned with it, hence exactly orthogonal to d.
struct View {
  Vector3 d;
  Vector3 w;
  double d_size = 0;
  double w_size = 0;

  void choose_half_line() {
    const double x = std::fabs(d.x);
    const double y = std::fabs(d.y);
    const double z = std::fabs(d.z);
    w = {-d.y, d.x, 0};
    if (x <= y && x <= z) {
      w = {0, -d.z, d.y};
    } else if (y <= z) {
      w = {d.z, 0, -d.x};
    }
    d_size = TileEdges::largest(d);
    w_size = TileEdges::largest(w);
  }
};

class StarCertifier {
 public:
  StarCertifier(const Leaf& leaf, std::span<const std::uint8_t> wanted, const Context& context)
      : leaf_(leaf), wanted_(wanted), context_(context), turns_(leaf.vertices.size(), 0) {
    view_of_.resize(leaf.vertices.size());
    std::uint32_t count = 0;
    for (std::size_t v = 0; v < wanted.size(); ++v) {
      view_of_[v] = count;
      count += wanted[v] != 0 ? 1U : 0U;
    }
    views_.resize(count);
  }

  std::vector<std::uint8_t> run() {
    sum_normals();
    for (View& view : views_) view.choose_half_line();
    for (std::uint32_t t = 0; t < leaf_.tiles.size(); ++t) {
      if (t % 16384 == 0) context_.poll();
      look_at(t);
    }
    for (std::uint8_t& turn : turns_) turn = turn == 1 ? 1 : 0;
    return std::move(turns_);
  }

 private:
  static constexpr std::uint8_t uncertain = 0x80;

  bool is_wanted(const Tile& tile) const { return (wanted_[tile[0]] | wanted_[tile[1]] | wanted_[tile[2]]) != 0; }

  void sum_normals() {
    for (std::uint32_t t = 0; t < leaf_.tiles.size(); ++t) {
      if (t % 16384 == 0) context_.poll();
      const Tile& tile = leaf_.tiles[t];
      if (!is_wanted(tile)) continue;
      const TileEdges edges(leaf_.vertices, tile);
      for (const std::uint32_t v : tile) {
        if (wanted_[v] == 0) continue;
        View& view = views_[view_of_[v]];
        view.d.x += edges.normal.x;
        view.d.y += edges.normal.y;
        view.d.z += edges.normal.z;
      }
    }
  }

  void look_at(std::uint32_t t) {
    const Tile& tile = leaf_.tiles[t];
    if (!is_wanted(tile)) return;
    const TileEdges edges(leaf_.vertices, tile);
    for (std::size_t k = 0; k < 3; ++k) {
      if (wanted_[tile[k]] == 0) continue;
      const std::size_t before = (k + 2) % 3;
      const View& view = views_[view_of_[tile[k]]];
      const double det = TileEdges::dot(edges.normal, view.d);
      const bool has_twins = (leaf_.twins[3 * t + k] != Leaf::no_twin) & (leaf_.twins[3 * t + before] != Leaf::no_twin);
      const bool is_turning = has_twins & (det > 0) & edges.is_certain_along(det, view.d_size);
      std::uint8_t& turns = turns_[tile[k]];
      if (!is_turning) {
        turns |= uncertain;
        continue;
      }
      const bool passes = is_before(view, tile[k], tile[(k + 1) % 3], edges.edge[k], edges.size[k]) &
                          !is_before(view, tile[k], tile[before], minus(edges.edge[before]), edges.size[before]);
      const auto counted = static_cast<std::uint8_t>(std::min<unsigned>(turns & 0x7FU, 2U) + (passes ? 1U : 0U));
      turns = static_cast<std::uint8_t>(counted | (turns & uncertain));
    }
  }

  // Whether the edge from v to p lies on the negative side of the plane w . e = 0, exactly. An edge in the plane counts
  // as positive: turning with the star, the half-line is passed on the way from negative to not negative.
  bool is_before(const View& view, std::uint32_t v, std::uint32_t p, const Vector3& e, double size) const {
    const double value = TileEdges::dot(e, view.w);
    if (TileEdges::is_certain(value, size * view.w_size)) [[likely]]
      return value < 0;
    return compare_along(view.w, leaf_.vertices[p], leaf_.vertices[v]) == Sign::negative;
  }

  const Leaf& leaf_;
  std::span<const std::uint8_t> wanted_;
  const Context& context_;
  std::vector<std::uint32_t> view_of_;  // per vertex that is wanted
  std::vector<View> views_;
  std::vector<std::uint8_t> turns_;  // how often each star passes the half-line, up to 3, and whether that is uncertain
};

}  // namespace

std::vector<std::uint8_t> certify_stars(const Leaf& leaf, std::span<const std::uint8_t> wanted,
                                        const Context& context) {
  if (!leaf.exact_vertices.empty()) return std::vector<std::uint8_t>(leaf.vertices.size(), 0);
  return StarCertifier(leaf, wanted, context).run();
}

}  // namespace quoin
