// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/large_vector.h"
#include "quoin/base/sign.h"
#include "quoin/triangulation/insertion_round.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin::detail {

/// The first of `count` vertices off the line of the first two, with these, counterclockwise: what an insertion starts
/// from. `turn(i)` is that of vertices 0, 1 and i.
template <class Turn>
std::optional<std::array<std::uint32_t, 3>> first_triangle(std::size_t count, const Turn& turn,
                                                           const Context& context) {
  for (std::uint32_t i = 2; i < count; ++i) {
    if (i % 4096 == 0) context.poll();
    const Sign side = turn(i);
    if (side == Sign::positive) return std::array<std::uint32_t, 3>{0, 1, i};
    if (side == Sign::negative) return std::array<std::uint32_t, 3>{1, 0, i};
  }
  return std::nullopt;
}

/// Inserts vertices one by one: walk to a triangle whose circle holds the point, remove all such triangles, and join
/// their boundary to the point (Bowyer 1981, Watson 1981), in rounds of growing size, each along the order of the
/// vertices (Amenta, Choi and Rote 2003).
///
/// The removed triangles are a disc without inner vertices, so their adjacency is a tree: searched depth first, it
/// gives the boundary in cyclic order, and no triangle need be marked. One more than removed, and one, are made anew:
/// the list never has holes.
///
/// Points with weights may hide each other: then the disc may have inner vertices, which go, its triangles are marked
/// so that none is met twice (the boundary is still in order: edges met twice drop out of it), and the list has holes
/// until the end.
///
/// `Predicates` says whether points may_hide, has a type Query, point(v) that makes one, turn(a, b, query) and
/// in_conflict(triangle, query); see delaunay_predicates2.h.
template <class Predicates>
class Insertion2 {
 public:
  using Query = typename Predicates::Query;

  Insertion2(const Predicates& predicates, std::size_t vertex_count, const Context& context)
      : predicates_(predicates), context_(context), infinite_(static_cast<std::uint32_t>(vertex_count)) {}

  /// `start` are three vertices, counterclockwise.
  LargeVector<TriangleLinks2> run(const std::array<std::uint32_t, 3>& start) {
    triangles_.reserve(2 * (std::size_t{infinite_} - 1));
    make_first(start);
    std::vector<std::vector<std::uint32_t>> sparse;
    for (std::uint32_t v = 0; v < infinite_; ++v) {
      const unsigned round = insertion_round(v);
      if (round == 0) continue;
      if (sparse.size() < round) sparse.resize(round);
      sparse[round - 1].push_back(v);
    }
    const auto is_start = [&](std::uint32_t v) { return v == start[0] || v == start[1] || v == start[2]; };
    for (; !sparse.empty(); sparse.pop_back()) {
      for (const std::uint32_t v : sparse.back()) {
        if (!is_start(v)) insert_and_poll(v);
      }
    }
    for (std::uint32_t v = 0; v < infinite_; ++v) {
      if (insertion_round(v) == 0 && !is_start(v)) insert_and_poll(v);
    }
    close_holes();
    return std::move(triangles_);
  }

  /// For a triangulation that changes: takes its triangles and gives them back after some insertions.
  void adopt(LargeVector<TriangleLinks2>&& triangles, std::uint32_t near) {
    triangles_ = std::move(triangles);
    last_ = near;
  }
  LargeVector<TriangleLinks2> release() { return std::move(triangles_); }
  void start(const std::array<std::uint32_t, 3>& corners) { make_first(corners); }
  /// The triangles about v; only where points do not hide. Polls at the first insertion and some of those after it.
  std::span<const std::uint32_t> insert(std::uint32_t v) {
    if (inserted_++ % poll_step == 0) context_.poll();
    insert_vertex(v);
    return removed_;
  }
  /// A triangle that holds the query, or an infinite one beyond whose edge it is.
  std::uint32_t find(const Query& query) const { return locate(query); }

 private:
  static constexpr std::uint32_t poll_step = 64;  // exact arithmetic of large spans takes long

  void make_first(const std::array<std::uint32_t, 3>& v) {
    const std::uint32_t n = infinite_;
    // Triangle 1 + k is beyond the edge opposite corner k.
    triangles_.push_back({v, {4 * 1 + 0, 4 * 2 + 0, 4 * 3 + 0}});
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t after = (k + 1) % 3;
      const std::uint32_t before = (k + 2) % 3;
      triangles_.push_back({{n, v[before], v[after]}, {k, 4 * (1 + before) + 2, 4 * (1 + after) + 1}});
    }
  }

  void insert_and_poll(std::uint32_t v) {
    if (++inserted_ % poll_step == 0) {
      if (inserted_ % (1024 * poll_step) == 0) {
        context_.progress("triangulation", static_cast<double>(inserted_) / infinite_);
      } else {
        context_.poll();
      }
    }
    insert_vertex(v);
  }

  void insert_vertex(std::uint32_t v) {
    const Query p = predicates_.point(v);
    const std::uint32_t first = locate(p);
    if constexpr (Predicates::may_hide) {
      if (!predicates_.in_conflict(triangles_[first], p)) return;
    }
    find_conflicts(first, p);
    fill_star(v);
  }

  // A triangle in conflict with the point: one that holds it, or an infinite one beyond whose edge it is.
  std::uint32_t locate(const Query& p) const {
    std::uint32_t t = last_;
    for (unsigned slot = 0; slot < 3; ++slot) {
      if (triangles_[t].corner[slot] == infinite_) {
        t = triangles_[t].across[slot] / 4;
        break;
      }
    }
    unsigned slot = 2;
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
      t = triangle.across[exit] / 4;
      slot = triangle.across[exit] % 4;
      if (triangles_[t].corner[slot] == infinite_) return t;
    }
  }

  void find_conflicts(std::uint32_t first, const Query& p) {
    removed_.clear();
    boundary_.clear();
    pending_.clear();
    remove(first);
    for (unsigned slot = 3; slot-- > 0;) pending_.push_back(triangles_[first].across[slot]);
    while (!pending_.empty()) {
      const std::uint32_t code = pending_.back();
      pending_.pop_back();
      if constexpr (Predicates::may_hide) {
        if (is_removed_.size() > code / 4 && is_removed_[code / 4] != 0) continue;
      }
      const TriangleLinks2& t = triangles_[code / 4];
      if (!predicates_.in_conflict(t, p)) {
        boundary_.push_back(code);
        continue;
      }
      remove(code / 4);
      const unsigned slot = code % 4;
      pending_.push_back(t.across[previous_slot(slot)]);
      pending_.push_back(t.across[next_slot(slot)]);
    }
  }

  void remove(std::uint32_t t) {
    removed_.push_back(t);
    if constexpr (Predicates::may_hide) {
      if (is_removed_.size() <= t) is_removed_.resize(std::max<std::size_t>(t + 1, triangles_.size()), 0);
      is_removed_[t] = 1;
    }
  }

  // As many ids as the star has triangles; where inner vertices were hidden, some are left over.
  void take_ids(std::size_t count) {
    if constexpr (Predicates::may_hide) {
      for (const std::uint32_t t : removed_) is_removed_[t] = 0;
      for (; removed_.size() > count; removed_.pop_back()) free_.push_back(removed_.back());
      for (; removed_.size() < count && !free_.empty(); free_.pop_back()) removed_.push_back(free_.back());
    }
    while (removed_.size() < count) {
      removed_.push_back(static_cast<std::uint32_t>(triangles_.size()));
      triangles_.emplace_back();
    }
  }

  // Triangles from the end fill the holes.
  void close_holes() {
    std::sort(free_.begin(), free_.end(), std::greater<>());
    for (const std::uint32_t hole : free_) {
      const auto last = static_cast<std::uint32_t>(triangles_.size() - 1);
      if (hole != last) {
        triangles_[hole] = triangles_[last];
        for (unsigned slot = 0; slot < 3; ++slot) {
          const std::uint32_t other = triangles_[hole].across[slot];
          triangles_[other / 4].across[other % 4] = 4 * hole + slot;
        }
      }
      triangles_.pop_back();
    }
  }

  // The boundary is in counterclockwise order, each edge as seen from outside.
  void fill_star(std::uint32_t v) {
    const std::size_t count = boundary_.size();
    take_ids(count);
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
  const Context& context_;
  std::uint32_t infinite_;
  std::uint32_t last_ = 0;
  std::uint32_t inserted_ = 0;
  LargeVector<TriangleLinks2> triangles_;
  std::vector<std::uint32_t> removed_;
  std::vector<std::uint32_t> boundary_;
  std::vector<std::uint32_t> pending_;
  std::vector<std::uint8_t> is_removed_;  // where points may hide
  std::vector<std::uint32_t> free_;
};

}  // namespace quoin::detail
