// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/large_vector.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin::detail {

/// Fills polygons left by removed triangles with the triangles whose circles hold no other corner, in the same places
/// of the list. Both sides of an edge may be such polygons. The list is as it was until `end`, which does not throw.
template <class Predicates>
class CavityFill2 {
 public:
  CavityFill2(const Predicates& predicates, TriangleArray2& triangles, std::uint32_t infinite, const Context& context)
      : predicates_(predicates), context_(context), triangles_(triangles), infinite_(infinite) {}

  /// `ids` are places for new triangles, `outer` the edges about the cavity as seen from outside.
  void begin(std::span<const std::uint32_t> ids, std::span<const std::uint32_t> outer) {
    ids_ = ids;
    made_.clear();
    sides_.clear();
    for (const std::uint32_t code : outer) {
      const auto& corner = triangles_[code / 4].corner;
      sides_.push_back({ends_of(corner[next_slot(code % 4)], corner[previous_slot(code % 4)]), code});
    }
  }

  /// The polygon on the left of the edge from -> to, whose other corners are the chain, from the first end to the
  /// second. Corners lie to the left of every base that can arise, unless `is_star`: then the polygon is star-shaped
  /// about a vertex that was removed, and may have the infinite one as a corner. O(k log k) where apexes are found
  /// evenly for k corners, O(k^2) at worst.
  void fill(std::uint32_t from, std::uint32_t to, std::span<const std::uint32_t> chain, bool is_star) {
    bases_.assign(1, {from, to, 0, chain.size()});
    while (!bases_.empty()) {
      const Base base = bases_.back();
      bases_.pop_back();
      std::size_t apex = base.begin;
      for (std::size_t i = base.begin + 1; i < base.end; ++i) {
        if (compared_++ % poll_step == 0) context_.poll();
        if (is_better(base, chain[i], chain[apex], is_star)) apex = i;
      }
      make_triangle({base.from, base.to, chain[apex]});
      if (apex > base.begin) bases_.push_back({base.from, chain[apex], base.begin, apex});
      if (apex + 1 < base.end) bases_.push_back({chain[apex], base.to, apex + 1, base.end});
    }
  }

  /// Puts the new triangles into their places, linked with each other and with those outside; how many were made.
  std::size_t end() {
    for (std::size_t i = 0; i < made_.size(); ++i) triangles_[ids_[i]].corner = made_[i];
    std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) { return a.ends < b.ends; });
    for (std::size_t i = 0; i + 1 < sides_.size(); i += 2) {
      const std::uint32_t a = sides_[i].code;
      const std::uint32_t b = sides_[i + 1].code;
      triangles_[a / 4].across[a % 4] = b;
      triangles_[b / 4].across[b % 4] = a;
    }
    return made_.size();
  }

 private:
  static constexpr std::size_t poll_step = 256;

  struct Side {
    std::uint64_t ends;
    std::uint32_t code;
  };
  struct Base {
    std::uint32_t from, to;
    std::size_t begin, end;  // of the chain above it
  };

  static std::uint64_t ends_of(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }

  // Finite, and to the left of the base, or the base is infinite: then every corner is beyond it.
  bool is_beyond(const Base& base, std::uint32_t v) const {
    if (v == infinite_) return false;
    if (base.from == infinite_ || base.to == infinite_) return true;
    return predicates_.turn(base.from, base.to, predicates_.point(v)) == Sign::positive;
  }

  bool is_better(const Base& base, std::uint32_t v, std::uint32_t apex, bool is_star) const {
    if (v == apex) return false;
    if (is_star) {
      if (!is_beyond(base, v)) return v == infinite_ && !is_beyond(base, apex);
      if (!is_beyond(base, apex)) return true;
    }
    return predicates_.in_conflict(TriangleLinks2{{base.from, base.to, apex}, {}}, predicates_.point(v));
  }

  void make_triangle(const std::array<std::uint32_t, 3>& corner) {
    const std::uint32_t id = ids_[made_.size()];
    made_.push_back(corner);
    for (unsigned slot = 0; slot < 3; ++slot) {
      sides_.push_back({ends_of(corner[next_slot(slot)], corner[previous_slot(slot)]), 4 * id + slot});
    }
  }

  const Predicates& predicates_;
  const Context& context_;
  TriangleArray2& triangles_;
  std::uint32_t infinite_;
  std::size_t compared_ = 0;
  std::span<const std::uint32_t> ids_;
  std::vector<std::array<std::uint32_t, 3>> made_;
  std::vector<Side> sides_;
  std::vector<Base> bases_;
};

}  // namespace quoin::detail
