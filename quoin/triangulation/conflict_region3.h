// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/triangulation/cell_array.h"
#include "quoin/triangulation/star_writer.h"

namespace quoin {

/// The cells of a triangulation of space whose spheres a point is in, and the facets between them and all others.
///
/// The cells are marked in the array until they are released, or given to others. O(1) tests for each of them.
template <class Signs>
class ConflictRegion3 {
 public:
  static constexpr std::uint32_t mark = 0x80000000U;  ///< on the first vertex of a cell that goes, or went

  ConflictRegion3(const Signs& signs, CellArray& cells) : signs_(signs), cells_(cells) {}

  /// Whether the point is in the sphere of a cell; of a ghost: beyond its facet, or in the circle of this.
  bool has(std::uint32_t cell, std::uint32_t q) const {
    const auto& v = cells_[cell].vertices;
    if (v[3] != vertex_at_infinity) [[likely]]
      return signs_.in_conflict(v[0], v[1], v[2], v[3], q);
    const int side = signs_.orientation(v[0], v[1], v[2], q);
    if (side != 0) return side > 0;
    // In the plane of the facet: its circle is where every sphere through it meets the plane.
    auto w = cells_[cells_[cell].neighbours[3] >> 2].vertices;
    w[0] &= ~mark;
    return signs_.in_conflict(w[0], w[1], w[2], w[3], q);
  }

  /// Finds all from one of them, and marks them; false where one of them is not the region's. Those
  /// found stay marked then too, and where it throws.
  template <class Region>
  bool find(std::uint32_t found, std::uint32_t q, const Region& region) {
    taken_.clear();
    facets_.clear();
    if (!region.owns(cells_[found].vertices)) return false;
    take(found);
    // The list grows on the way.
    for (std::size_t k = 0; k < taken_.size();) {
      const std::size_t end = std::min(taken_.size(), k + most_at_once);
      test_neighbours(k, end, q);
      k = end;
      if (!take_tested(region)) return false;
    }
    return true;
  }

  /// Cells that go, in the order in which they were found.
  const std::vector<std::uint32_t>& cells() const { return taken_; }
  const std::vector<HoleFacet>& facets() const { return facets_; }

  /// They stay.
  void release() {
    for (const std::uint32_t cell : taken_) cells_[cell].vertices[0] &= ~mark;
  }

 private:
  /// A facet of a cell that goes, from both sides, and whether the outer one goes too.
  struct Tested {
    std::uint32_t inner;
    std::uint32_t outer;
    bool is_in_conflict;
  };
  static constexpr std::size_t most_at_once = 2;  // cells; more meet the same neighbours more often

  void take(std::uint32_t cell) {
    taken_.push_back(cell);
    cells_[cell].vertices[0] |= mark;
    for (const std::uint32_t next : cells_[cell].neighbours) __builtin_prefetch(&cells_[next >> 2]);
  }

  /// Tests what is beyond the facets of several cells one after the other, and only then acts upon it: half of the
  /// answers surprise the processor, which by then has the next ones under way.
  void test_neighbours(std::size_t begin, std::size_t end, std::uint32_t q) {
    tested_count_ = 0;
    for (std::size_t k = begin; k < end; ++k) {
      for (unsigned i = 0; i < 4; ++i) {
        const std::uint32_t outer = cells_[taken_[k]].neighbours[i];
        tested_[tested_count_] = {taken_[k] * 4 + i, outer, false};
        tested_count_ += (cells_[outer >> 2].vertices[0] & mark) == 0 ? 1 : 0;
      }
    }
    for (std::size_t j = 0; j < tested_count_; ++j) tested_[j].is_in_conflict = has(tested_[j].outer >> 2, q);
  }

  template <class Region>
  bool take_tested(const Region& region) {
    for (std::size_t j = 0; j < tested_count_; ++j) {
      const auto& [inner, outer, is_in_conflict] = tested_[j];
      if (is_in_conflict) {
        const std::uint32_t next = outer >> 2;
        if ((cells_[next].vertices[0] & mark) != 0) continue;  // met twice
        if (!region.owns(cells_[next].vertices)) return false;
        take(next);
      } else {
        std::array<std::uint32_t, 4> v = cells_[inner >> 2].vertices;
        v[0] &= ~mark;
        const auto& [a, b, c] = facet_slots[inner & 3];
        facets_.push_back({outer, {v[a], v[b], v[c]}});
      }
    }
    return true;
  }

  const Signs& signs_;
  CellArray& cells_;
  std::vector<std::uint32_t> taken_;
  std::vector<HoleFacet> facets_;
  std::array<Tested, 4 * most_at_once> tested_{};
  std::size_t tested_count_ = 0;
};

}  // namespace quoin
