// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "quoin/triangulation/cell_array.h"
#include "quoin/triangulation/star_numbers.h"

namespace quoin {

/// Between a cell that goes and one that stays: its vertices as in facet_slots, and the one that stays.
struct HoleFacet {
  std::uint32_t outer;
  std::array<std::uint32_t, 3> vertices;
};

/// Writes the star of a vertex into a hole of a triangulation of space: a cell for each facet of the hole.
class StarWriter {
 public:
  explicit StarWriter(CellArray& cells) : cells_(cells) { table_.resize(most_local * most_local); }

  /// Whether so many facets have no more vertices than StarNumbers takes: a sphere of more triangles has more.
  static bool has_table(std::size_t facets) { return facets <= 2 * (most_local - 2) - 4; }

  /// All memory that `write` takes for so many facets.
  void reserve(std::size_t facets) {
    if (has_table(facets)) {
      facet_numbers_.reserve(facets);
    } else {
      edges_.reserve(3 * facets);
    }
  }

  /// `ids` are places of cells, one for each facet.
  void write(std::span<const HoleFacet> facets, std::span<const std::uint32_t> ids, std::uint32_t q) {
    if (has_table(facets.size())) {
      write_by_table(facets, ids, q);
    } else {
      write_by_sorting(facets, ids, q);
    }
  }

 private:
  static constexpr unsigned most_local = StarNumbers::most;  // vertices of a star in the table; the last is infinity

  /// The cell of a facet and q; the slots of the facet's vertices and of q are those of `slots_of`.
  void write_cell(std::uint32_t id, const HoleFacet& facet, std::uint32_t q) {
    const auto& [a, b, c] = facet.vertices;
    TriangulationCell& cell = cells_[id];
    const bool is_ghost = c == vertex_at_infinity;
    if (is_ghost) {
      cell.vertices = {b, a, q, c};
    } else {
      cell.vertices = {a, b, c, q};
    }
    const std::uint32_t apex = is_ghost ? 2 : 3;
    cell.neighbours[apex] = facet.outer;
    cells_[facet.outer >> 2].neighbours[facet.outer & 3] = id * 4 + apex;
  }

  static constexpr std::array<std::uint32_t, 3> slots_of(const HoleFacet& facet) {
    return facet.vertices[2] == vertex_at_infinity ? std::array<std::uint32_t, 3>{1, 0, 3}
                                                   : std::array<std::uint32_t, 3>{0, 1, 2};
  }

  unsigned local_number(std::uint32_t v) { return v == vertex_at_infinity ? most_local - 1 : numbers_.number(v); }

  /// Each directed edge of the hole's surface is of one facet, and its reverse of the one beyond.
  void write_by_table(std::span<const HoleFacet> facets, std::span<const std::uint32_t> ids, std::uint32_t q) {
    facet_numbers_.clear();
    numbers_.clear();
    for (std::size_t k = 0; k < facets.size(); ++k) {
      const HoleFacet& facet = facets[k];
      const std::array<unsigned, 3> l{local_number(facet.vertices[0]), local_number(facet.vertices[1]),
                                      local_number(facet.vertices[2])};
      const std::uint32_t id = ids[k];
      facet_numbers_.push_back(l);
      write_cell(id, facet, q);
      const auto slots = slots_of(facet);
      table_[l[0] * most_local + l[1]] = id * 4 + slots[2];
      table_[l[1] * most_local + l[2]] = id * 4 + slots[0];
      table_[l[2] * most_local + l[0]] = id * 4 + slots[1];
    }
    for (std::size_t k = 0; k < facets.size(); ++k) {
      const auto& l = facet_numbers_[k];
      const auto slots = slots_of(facets[k]);
      TriangulationCell& cell = cells_[ids[k]];
      cell.neighbours[slots[2]] = table_[l[1] * most_local + l[0]];
      cell.neighbours[slots[0]] = table_[l[2] * most_local + l[1]];
      cell.neighbours[slots[1]] = table_[l[0] * most_local + l[2]];
    }
  }

  void write_by_sorting(std::span<const HoleFacet> facets, std::span<const std::uint32_t> ids, std::uint32_t q) {
    edges_.clear();
    for (std::size_t k = 0; k < facets.size(); ++k) {
      const HoleFacet& facet = facets[k];
      write_cell(ids[k], facet, q);
      const auto slots = slots_of(facet);
      for (unsigned i = 0; i < 3; ++i) {
        const std::uint32_t from = facet.vertices[i];
        const std::uint32_t to = facet.vertices[(i + 1) % 3];
        edges_.emplace_back(std::uint64_t{std::min(from, to)} << 32 | std::max(from, to),
                            ids[k] * 4 + slots[(i + 2) % 3]);
      }
    }
    std::sort(edges_.begin(), edges_.end());
    for (std::size_t i = 0; i + 1 < edges_.size(); i += 2) {
      const std::uint32_t one = edges_[i].second;
      const std::uint32_t other = edges_[i + 1].second;
      cells_[one >> 2].neighbours[one & 3] = other;
      cells_[other >> 2].neighbours[other & 3] = one;
    }
  }

  CellArray& cells_;
  StarNumbers numbers_;
  std::vector<std::uint32_t> table_;
  std::vector<std::array<unsigned, 3>> facet_numbers_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> edges_;
};

}  // namespace quoin
