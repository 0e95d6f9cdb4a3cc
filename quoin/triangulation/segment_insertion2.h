// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/large_vector.h"
#include "quoin/triangulation/cavity_fill2.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin::detail {

/// Makes segments between vertices edges of a triangulation that stays Delaunay but for them: the triangles that a
/// segment crosses are removed, and the two polygons on its sides filled, each with the apex over its base whose circle
/// holds no other corner, and so on over the two new bases (Anglada 1997).
///
/// Segments do not cross each other, and no vertex lies inside one. `triangles` are those of such a triangulation, with
/// the infinite vertex at `vertex_count`. Predicates as for Insertion2.
template <class Predicates>
class SegmentInsertion2 {
 public:
  SegmentInsertion2(const Predicates& predicates, TriangleArray2& triangles, std::size_t vertex_count,
                    const Context& context)
      : predicates_(predicates),
        context_(context),
        triangles_(triangles),
        infinite_(static_cast<std::uint32_t>(vertex_count)),
        star_(vertex_count + 1),
        is_removed_(triangles.size(), 0),
        fill_(predicates, triangles, infinite_, context) {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) update_star(t);
  }

  /// O(d + k log k) for k crossed triangles where apexes are found evenly, O(d + k^2) at worst; d is the smaller degree
  /// of the two vertices.
  void insert(std::uint32_t u, std::uint32_t v) {
    if (!find_first_crossing(u, v)) return;
    cross_triangles();
    note_outer_edges();
    fill_.begin(removed_, outer_);
    fill_.fill(from_, to_, left_, false);
    std::reverse(right_.begin(), right_.end());
    fill_.fill(to_, from_, right_, false);
    fill_.end();
    for (const std::uint32_t t : removed_) {
      is_removed_[t] = 0;
      update_star(t);
    }
  }

 private:
  std::uint32_t source(std::uint32_t code) const { return triangles_[code / 4].corner[next_slot(code % 4)]; }
  std::uint32_t target(std::uint32_t code) const { return triangles_[code / 4].corner[previous_slot(code % 4)]; }
  std::uint32_t around_source(std::uint32_t code) const { return triangles_[code / 4].across[previous_slot(code % 4)]; }

  void update_star(std::uint32_t t) {
    for (unsigned slot = 0; slot < 3; ++slot) star_[triangles_[t].corner[slot]] = 4 * t + previous_slot(slot);
  }

  // Whether the way to `to` leaves through the edge across from the source of `code`.
  bool leaves_here(std::uint32_t code, std::uint32_t to) const {
    const std::uint32_t from = source(code);
    const std::uint32_t right = target(code);
    const std::uint32_t left = triangles_[code / 4].corner[code % 4];
    if (right == infinite_ || left == infinite_) return false;
    return predicates_.turn(from, right, predicates_.point(to)) == Sign::positive &&
           predicates_.turn(from, left, predicates_.point(to)) == Sign::negative;
  }

  // Turns about both ends at once, so that it takes no longer than about the one of smaller degree. False if there is
  // such an edge.
  bool find_first_crossing(std::uint32_t u, std::uint32_t v) {
    std::uint32_t at_u = star_[u];
    std::uint32_t at_v = star_[v];
    for (;;) {
      if (target(at_u) == v || target(at_v) == u) return false;
      if (leaves_here(at_u, v)) return start(u, v, at_u);
      if (leaves_here(at_v, u)) return start(v, u, at_v);
      at_u = around_source(at_u);
      at_v = around_source(at_v);
    }
  }

  bool start(std::uint32_t from, std::uint32_t to, std::uint32_t code) {
    from_ = from;
    to_ = to;
    removed_.assign(1, code / 4);
    right_.assign(1, target(code));
    left_.assign(1, triangles_[code / 4].corner[code % 4]);
    entry_ = triangles_[code / 4].across[next_slot(code % 4)];
    return true;
  }

  void cross_triangles() {
    for (;;) {
      const TriangleLinks2& t = triangles_[entry_ / 4];
      const unsigned slot = entry_ % 4;
      const std::uint32_t apex = t.corner[slot];
      removed_.push_back(entry_ / 4);
      if (removed_.size() % 256 == 0) context_.poll();
      if (apex == to_) break;
      const bool is_left = predicates_.turn(from_, to_, predicates_.point(apex)) == Sign::positive;
      (is_left ? left_ : right_).push_back(apex);
      entry_ = t.across[is_left ? next_slot(slot) : previous_slot(slot)];
    }
    for (const std::uint32_t t : removed_) is_removed_[t] = 1;
  }

  void note_outer_edges() {
    outer_.clear();
    for (const std::uint32_t t : removed_) {
      for (const std::uint32_t other : triangles_[t].across) {
        if (is_removed_[other / 4] == 0) outer_.push_back(other);
      }
    }
  }

  const Predicates& predicates_;
  const Context& context_;
  TriangleArray2& triangles_;
  std::uint32_t infinite_;
  std::vector<std::uint32_t> star_;
  std::vector<std::uint8_t> is_removed_;
  std::uint32_t from_ = 0;
  std::uint32_t to_ = 0;
  std::uint32_t entry_ = 0;
  std::vector<std::uint32_t> removed_;
  std::vector<std::uint32_t> left_;
  std::vector<std::uint32_t> right_;
  std::vector<std::uint32_t> outer_;
  CavityFill2<Predicates> fill_;
};

}  // namespace quoin::detail
