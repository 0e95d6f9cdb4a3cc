// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/sign.h"
#include "quoin/triangulation/plane_region.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin::detail {

/// Inserts vertices one by one: walk to a triangle whose circle holds the point, remove all such triangles, and join
/// their boundary to the point (Bowyer 1981, Watson 1981).
///
/// The removed triangles are a disc without inner vertices, so their adjacency is a tree: searched depth first, it
/// gives the boundary in cyclic order, and no triangle need be marked. Two more are made than removed, so each vertex
/// brings places for two.
///
/// Points with weights may hide each other: then the disc may have inner vertices, which go, its triangles are marked
/// so that none is met twice (the boundary is still in order: edges met twice drop out of it), and places are left
/// over.
///
/// `Predicates` says whether points may_hide, has a type Query, point(v) that makes one, turn(a, b, query) and
/// in_conflict(triangle, query); see delaunay_predicates2.h. Several threads may have one of these each, on the same
/// triangles, each for points of a region of its own.
template <class Predicates>
class Insertion2 {
 public:
  using Query = typename Predicates::Query;
  enum class Place {
    inserted,
    hidden,
    late  ///< it would change what is not its region's; nothing has changed
  };
  static constexpr std::uint32_t no_triangle = 0xFFFFFFFF;

  /// The array stays the caller's, and so do places of it that are given here.
  Insertion2(const Predicates& predicates, TriangleArray2& triangles, std::uint32_t infinite)
      : predicates_(predicates), triangles_(triangles), infinite_(infinite) {}

  /// The triangle of three vertices, counterclockwise, and those beyond its edges: the first four of the array.
  void start(const std::array<std::uint32_t, 3>& v) {
    // Triangle 1 + k is beyond the edge opposite corner k.
    triangles_[0] = {v, {4 * 1 + 0, 4 * 2 + 0, 4 * 3 + 0}};
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t after = (k + 1) % 3;
      const std::uint32_t before = (k + 2) % 3;
      triangles_[1 + k] = {{infinite_, v[before], v[after]}, {k, 4 * (1 + before) + 2, 4 * (1 + after) + 1}};
    }
    last_ = 0;
  }

  /// Where walks begin: the triangle inserted last, or this one.
  void begin_at(std::uint32_t triangle) { last_ = triangle; }
  std::uint32_t last() const { return last_; }
  /// The triangles about the vertex inserted last.
  std::span<const std::uint32_t> star() const { return removed_; }
  /// Places in which there is no triangle; only where points hide.
  bool is_left_over(std::uint32_t triangle) const {
    return Predicates::may_hide && (triangles_[triangle].corner[0] & mark) != 0;
  }
  std::vector<std::uint32_t>& left_over() { return left_over_; }

  /// `fresh` and the one after it are places of no triangle.
  template <class Region>
  Place insert(std::uint32_t v, std::uint32_t fresh, Region region) {
    const Query p = predicates_.point(v);
    const std::uint32_t first = find(p, region);
    if (first == no_triangle) return Place::late;
    if constexpr (Predicates::may_hide) {
      if (!predicates_.in_conflict(triangles_[first], p)) {
        leave_over(fresh);
        leave_over(fresh + 1);
        return Place::hidden;
      }
    }
    if (!find_conflicts(first, p, region)) return Place::late;
    take_places(fresh);
    fill_star(v);
    return Place::inserted;
  }

  /// The same in two steps where points may hide, for those who want to know what goes. First the triangles in conflict
  /// with a query, of which one is known; nothing has changed yet, nor has it after an exception.
  template <class Region>
  std::span<const std::uint32_t> conflicts(std::uint32_t first, const Query& p, Region region) {
    try {
      find_conflicts(first, p, region);
    } catch (...) {
      give_back();
      throw;
    }
    give_back();
    return removed_;
  }
  /// Then the vertex, which was the query, in their places. After an exception these alone hold what they should not.
  void replace_conflicts(std::uint32_t v, std::uint32_t fresh) {
    take_places(fresh);
    fill_star(v);
  }

  /// A triangle that holds the query, or an infinite one beyond whose edge it is. None where the walk would leave the
  /// edges of the region, which owns the triangle where it begins.
  template <class Region>
  std::uint32_t find(const Query& p, Region region) const {
    std::uint32_t t = last_;
    unsigned slot = 2;
    for (unsigned k = 0; k < 3; ++k) {
      if (triangles_[t].corner[k] == infinite_) {
        slot = triangles_[t].across[k] % 4;
        t = triangles_[t].across[k] / 4;
        break;
      }
    }
    for (bool is_first = true;; is_first = false) {
      const TriangleLinks2& triangle = triangles_[t];
      const unsigned one = next_slot(slot);
      const unsigned two = previous_slot(slot);
      unsigned exit = 3;
      if (predicates_.turn(triangle.corner[two], triangle.corner[slot], p) == Sign::negative) {
        exit = one;
      } else if (predicates_.turn(triangle.corner[slot], triangle.corner[one], p) == Sign::negative) {
        exit = two;
      } else if (is_first && predicates_.turn(triangle.corner[one], triangle.corner[two], p) == Sign::negative) {
        exit = slot;
      }
      if (exit == 3) return t;
      // The edge across from the slot is the region's.
      if (exit != slot && !region.allows(triangle.corner[slot])) return no_triangle;
      t = triangle.across[exit] / 4;
      slot = triangle.across[exit] % 4;
      if (triangles_[t].corner[slot] == infinite_) return t;
    }
  }

 private:
  static constexpr std::uint32_t mark = 0x80000000U;  // on the first corner of what goes or went, where points may hide

  /// False where a triangle is not the region's.
  template <class Region>
  bool find_conflicts(std::uint32_t first, const Query& p, Region region) {
    removed_.clear();
    boundary_.clear();
    pending_.clear();
    if (!region.owns(triangles_[first].corner)) return false;
    remove(first);
    for (unsigned slot = 3; slot-- > 0;) pending_.push_back(triangles_[first].across[slot]);
    while (!pending_.empty()) {
      const std::uint32_t code = pending_.back();
      pending_.pop_back();
      const TriangleLinks2& t = triangles_[code / 4];
      if constexpr (Predicates::may_hide) {
        if ((t.corner[0] & mark) != 0) continue;
      }
      if (!predicates_.in_conflict(t, p)) {
        boundary_.push_back(code);
        continue;
      }
      const unsigned slot = code % 4;
      if (!region.allows(t.corner[slot])) {  // the ends of the edge are
        give_back();
        return false;
      }
      remove(code / 4);
      pending_.push_back(t.across[previous_slot(slot)]);
      pending_.push_back(t.across[next_slot(slot)]);
    }
    return true;
  }

  void remove(std::uint32_t t) {
    removed_.push_back(t);
    if constexpr (Predicates::may_hide) triangles_[t].corner[0] |= mark;
  }
  void give_back() {
    if constexpr (Predicates::may_hide) {
      for (const std::uint32_t t : removed_) triangles_[t].corner[0] &= ~mark;
    }
  }
  void leave_over(std::uint32_t place) {
    triangles_[place].corner[0] = mark;
    left_over_.push_back(place);
  }

  // As many as the star has triangles. For each inner vertex that is hidden two are left over.
  void take_places(std::uint32_t fresh) {
    removed_.push_back(fresh);
    removed_.push_back(fresh + 1);
    if constexpr (Predicates::may_hide) {
      for (; removed_.size() > boundary_.size(); removed_.pop_back()) leave_over(removed_.back());
    }
  }

  // The boundary is in counterclockwise order, each edge as seen from outside.
  void fill_star(std::uint32_t v) {
    const std::size_t count = boundary_.size();
    std::uint32_t before = removed_[count - 1];
    std::uint32_t from = triangles_[boundary_[0] / 4].corner[previous_slot(boundary_[0] % 4)];
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint32_t outer = boundary_[k];
      const std::uint32_t id = removed_[k];
      const std::uint32_t after = k + 1 < count ? removed_[k + 1] : removed_[0];
      TriangleLinks2& beyond = triangles_[outer / 4];
      const std::uint32_t to = beyond.corner[next_slot(outer % 4)];
      beyond.across[outer % 4] = 4 * id + 2;
      triangles_[id] = {{from, to, v}, {4 * after + 1, 4 * before, outer}};
      from = to;
      before = id;
    }
    last_ = removed_[0];
  }

  const Predicates& predicates_;
  TriangleArray2& triangles_;
  std::uint32_t infinite_;
  std::uint32_t last_ = 0;
  std::vector<std::uint32_t> removed_;
  std::vector<std::uint32_t> boundary_;
  std::vector<std::uint32_t> pending_;
  std::vector<std::uint32_t> left_over_;
};

}  // namespace quoin::detail
