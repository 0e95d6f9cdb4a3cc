// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/triangulation/cell_array.h"
#include "quoin/triangulation/cell_pool.h"
#include "quoin/triangulation/conflict_region3.h"
#include "quoin/triangulation/rank_region.h"
#include "quoin/triangulation/star_numbers.h"

namespace quoin {

/// Inserts points into a triangulation of space, one after the other: walks to the cell of the point, takes away the
/// cells whose spheres it is in, and fills the hole with its star.
///
/// `Signs` owns all geometry: `orientation` of four vertices and `in_conflict` of a cell of finite vertices and a
/// fifth. It must be that of a regular triangulation; then walks end (Edelsbrunner 1990) and holes are star-shaped.
/// Where `Signs::may_hide`, a point may be in conflict with no cell, or the last one of all cells of another vertex.
/// Several threads may have one of these each, on the same cells, each for points of a region of its own.
/// Expected O(1) cells per point for points in insertion rounds, after the walk. Source: Bowyer 1981; Watson 1981.
template <class Signs>
class IncrementalTriangulation {
 public:
  enum class Place {
    inserted,
    hidden,
    late  ///< it would change what is not its region's, or there is no room; nothing has changed
  };

  IncrementalTriangulation(const Signs& signs, CellArray& cells)
      : signs_(signs), cells_(cells), conflict_(signs, cells) {
    table_.resize(most_local * most_local);
  }

  /// The first cell, of four vertices in any order that are not coplanar, and its ghosts.
  void start(std::array<std::uint32_t, 4> v) {
    if (signs_.orientation(v[0], v[1], v[2], v[3]) < 0) std::swap(v[2], v[3]);
    cells_.assign(5, {});
    cells_[0].vertices = v;
    for (unsigned i = 0; i < 4; ++i) {
      // Seen from outside the facet turns the other way.
      const std::array<unsigned, 3> f = facet_slots[i];
      cells_[i + 1].vertices = {v[f[1]], v[f[0]], v[f[2]], vertex_at_infinity};
      cells_[i + 1].neighbours[3] = i;
      cells_[0].neighbours[i] = (i + 1) * 4 + 3;
      const std::array<unsigned, 3> opposite{f[1], f[0], f[2]};
      for (unsigned slot = 0; slot < 3; ++slot) {
        // Across the edge without this vertex: the ghost of the facet opposite to it.
        const std::array<unsigned, 3> g = facet_slots[opposite[slot]];
        const unsigned there = g[1] == i ? 0 : g[0] == i ? 1 : 2;
        cells_[i + 1].neighbours[slot] = (opposite[slot] + 1) * 4 + there;
      }
    }
    last_ = 0;
  }

  /// Where walks begin.
  void begin_at(std::uint32_t cell) { last_ = cell; }
  std::uint32_t last() const { return last_; }
  bool is_free(std::uint32_t cell) const { return (cells_[cell].vertices[0] & mark) != 0; }
  /// Cells to be made use of.
  CellPool& pool() { return pool_; }
  void take_pool(CellPool pool) {
    pool_ = std::move(pool);
    has_room_ = true;
  }
  /// False from when a point of a region wanted more cells than the pool had.
  bool has_room() const { return has_room_; }

  /// The cell in which the walk from the cell inserted last ends: a finite one that holds the point, or a ghost of a
  /// facet that sees it. `no_cell` where the walk would leave the facets of the region.
  template <class Region>
  std::uint32_t locate(std::uint32_t q, const Region& region) const {
    std::uint32_t cell = last_;
    if (cells_[cell].vertices[3] == vertex_at_infinity) cell = cells_[cell].neighbours[3] >> 2;
    unsigned entry = 4;
    for (;;) {
      const auto& v = cells_[cell].vertices;
      if (v[3] == vertex_at_infinity) return cell;
      bool is_shut = false;
      unsigned exit = 0;
      for (; exit < 4; ++exit) {
        if (exit == entry) continue;
        const auto& [a, b, c] = facet_slots[exit];
        if (signs_.orientation(v[a], v[b], v[c], q) >= 0) continue;
        if (region.owns_facet(v[a], v[b], v[c])) break;
        is_shut = true;
      }
      if (exit == 4) return is_shut ? no_cell : cell;
      const std::uint32_t next = cells_[cell].neighbours[exit];
      entry = next & 3;
      cell = next >> 2;
    }
  }

  /// `when_hidden` is called with each vertex that the new one hides.
  template <class Region, class WhenHidden>
  Place insert(std::uint32_t q, const Region& region, [[maybe_unused]] const WhenHidden& when_hidden) {
    const std::uint32_t found = locate(q, region);
    if (found == no_cell) return Place::late;
    if constexpr (Signs::may_hide) {
      if (!conflict_.has(found, q)) return Place::hidden;
    }
    if (!conflict_.find(found, q, region) || !has_room_for_star<Region>()) {
      conflict_.release();
      return Place::late;
    }
    if constexpr (Signs::may_hide) collect_vertices();
    if (!fill_by_table(q)) fill_by_sorting(q);
    if constexpr (Signs::may_hide) {
      for (const std::uint32_t v : inner_) when_hidden(v);
    }
    for (std::size_t k = conflict_.facets().size(); k < conflict_.cells().size(); ++k) pool_.add(conflict_.cells()[k]);
    last_ = new_cells_.back();
    return Place::inserted;
  }

  /// Cells that are of no use move out of the array.
  void compact() {
    cells_.resize(pool_.without_end(cells_.size()));
    std::vector<std::uint32_t> holes = pool_.places();
    std::sort(holes.rbegin(), holes.rend());
    for (const std::uint32_t hole : holes) {
      const auto end = static_cast<std::uint32_t>(cells_.size() - 1);
      if (hole != end) {
        cells_[hole] = cells_[end];
        for (unsigned i = 0; i < 4; ++i) {
          const std::uint32_t mate = cells_[hole].neighbours[i];
          cells_[mate >> 2].neighbours[mate & 3] = hole * 4 + i;
        }
        if (last_ == end) last_ = hole;
      }
      cells_.pop_back();
    }
    pool_ = {};
  }

  static constexpr std::uint32_t no_cell = 0xFFFFFFFF;
  static constexpr std::size_t most_cells = std::size_t{1} << 30;

 private:
  using Conflict = ConflictRegion3<Signs>;
  using Facet = typename Conflict::Facet;
  static constexpr std::uint32_t mark = Conflict::mark;
  static constexpr unsigned most_local = StarNumbers::most;  // vertices of a star in the table; the last is infinity

  template <class Region>
  bool has_room_for_star() {
    has_room_ = Region::may_grow || conflict_.facets().size() <= conflict_.cells().size() + pool_.size();
    return has_room_;
  }

  std::uint32_t new_cell(std::size_t k) {
    if (k < conflict_.cells().size()) return conflict_.cells()[k];
    if (pool_.size() > 0) return pool_.take();
    // Neighbours are four codes of 32 bits for each cell.
    if (cells_.size() >= most_cells) throw InputError("the triangulation has more than 2^30 cells");
    cells_.emplace_back();
    return static_cast<std::uint32_t>(cells_.size() - 1);
  }

  /// The cell of a facet and q; the slots of the facet's vertices and of q are those of `slots_of`.
  void write_cell(std::uint32_t id, const Facet& facet, std::uint32_t q) {
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

  static constexpr std::array<std::uint32_t, 3> slots_of(const Facet& facet) {
    return facet.vertices[2] == vertex_at_infinity ? std::array<std::uint32_t, 3>{1, 0, 3}
                                                   : std::array<std::uint32_t, 3>{0, 1, 2};
  }

  unsigned local_number(std::uint32_t v) { return v == vertex_at_infinity ? most_local - 1 : numbers_.number(v); }

  /// Each directed edge of the hole's surface is of one facet, and its reverse of the one beyond.
  bool fill_by_table(std::uint32_t q) {
    new_cells_.clear();
    facet_numbers_.clear();
    numbers_.clear();
    if (conflict_.facets().size() > 2 * (most_local - 2) - 4)
      return false;  // a sphere of more triangles has more vertices
    for (std::size_t k = 0; k < conflict_.facets().size(); ++k) {
      const Facet& facet = conflict_.facets()[k];
      const std::array<unsigned, 3> l{local_number(facet.vertices[0]), local_number(facet.vertices[1]),
                                      local_number(facet.vertices[2])};
      const std::uint32_t id = new_cell(k);
      new_cells_.push_back(id);
      facet_numbers_.push_back(l);
      write_cell(id, facet, q);
      const auto slots = slots_of(facet);
      table_[l[0] * most_local + l[1]] = id * 4 + slots[2];
      table_[l[1] * most_local + l[2]] = id * 4 + slots[0];
      table_[l[2] * most_local + l[0]] = id * 4 + slots[1];
    }
    for (std::size_t k = 0; k < conflict_.facets().size(); ++k) {
      const auto& l = facet_numbers_[k];
      const auto slots = slots_of(conflict_.facets()[k]);
      TriangulationCell& cell = cells_[new_cells_[k]];
      cell.neighbours[slots[2]] = table_[l[1] * most_local + l[0]];
      cell.neighbours[slots[0]] = table_[l[2] * most_local + l[1]];
      cell.neighbours[slots[1]] = table_[l[0] * most_local + l[2]];
    }
    return true;
  }

  void fill_by_sorting(std::uint32_t q) {
    edges_.clear();
    for (std::size_t k = 0; k < conflict_.facets().size(); ++k) {
      const Facet& facet = conflict_.facets()[k];
      const std::uint32_t id = new_cell(k);
      new_cells_.push_back(id);
      write_cell(id, facet, q);
      const auto slots = slots_of(facet);
      for (unsigned i = 0; i < 3; ++i) {
        const std::uint32_t from = facet.vertices[i];
        const std::uint32_t to = facet.vertices[(i + 1) % 3];
        edges_.push_back({std::uint64_t{std::min(from, to)} << 32 | std::max(from, to), id * 4 + slots[(i + 2) % 3]});
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

  /// Of the cells that go, those on no facet of the hole: they are hidden afterwards.
  void collect_vertices() {
    inner_.clear();
    outer_.clear();
    for (const std::uint32_t cell : conflict_.cells()) {
      for (const std::uint32_t v : cells_[cell].vertices) inner_.push_back(v & ~mark);
    }
    for (const Facet& facet : conflict_.facets())
      outer_.insert(outer_.end(), facet.vertices.begin(), facet.vertices.end());
    for (auto* list : {&inner_, &outer_}) {
      std::sort(list->begin(), list->end());
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    // The vertex at infinity is the last one, and hidden by none.
    if (inner_.back() == vertex_at_infinity) inner_.pop_back();
    std::erase_if(inner_, [this](std::uint32_t v) { return std::binary_search(outer_.begin(), outer_.end(), v); });
  }

  const Signs& signs_;
  CellArray& cells_;
  CellPool pool_;
  bool has_room_ = true;
  StarNumbers numbers_;
  std::vector<std::uint32_t> table_;
  Conflict conflict_;
  std::vector<std::uint32_t> new_cells_;
  std::vector<std::array<unsigned, 3>> facet_numbers_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> edges_;
  std::vector<std::uint32_t> inner_;
  std::vector<std::uint32_t> outer_;
  std::uint32_t last_ = 0;
};

}  // namespace quoin
