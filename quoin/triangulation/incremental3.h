// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/triangulation/cell_array.h"
#include "quoin/triangulation/cell_pool.h"
#include "quoin/triangulation/conflict_region3.h"
#include "quoin/triangulation/rank_region.h"
#include "quoin/triangulation/star_numbers.h"
#include "quoin/triangulation/star_writer.h"

namespace quoin {

/// Inserts points into a triangulation of space, one after the other: walks to the cell of the point, takes away the
/// cells whose spheres it is in, and fills the hole with its star.
///
/// `Signs` owns all geometry: `orientation` of four vertices and `in_conflict` of a cell of finite vertices and a
/// fifth. It must be that of a regular triangulation; then walks end (Edelsbrunner 1990) and holes are star-shaped.
/// Where `Signs::may_hide`, a point may be in conflict with no cell, or the last one of all cells of another vertex.
/// Several threads may have one of these each, on the same cells, each for points of a region of its own. Where an
/// insertion fails, by want of memory or a region that throws, the cells are as they were.
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
      : signs_(signs), cells_(cells), star_(cells), conflict_(signs, cells) {}

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
    pool_ = {};
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
  Place insert(std::uint32_t q, const Region& region, const WhenHidden& when_hidden) {
    const std::uint32_t found = locate(q, region);
    return found == no_cell ? Place::late : insert_at(found, q, region, when_hidden);
  }

  /// The same where the cell is known that `locate` would find.
  template <class Region, class WhenHidden>
  Place insert_at(std::uint32_t found, std::uint32_t q, const Region& region, const WhenHidden& when_hidden) {
    if constexpr (Signs::may_hide) {
      if (hides(found, q)) return Place::hidden;
    }
    if (!open(found, q, region)) return Place::late;
    fill(q, when_hidden);
    return Place::inserted;
  }

  /// Whether a vertex that is not inserted would be hidden; `found` is what `locate` gave.
  bool hides(std::uint32_t found, std::uint32_t q) const { return !conflict_.has(found, q); }

  /// Replaces cells that `find_conflicts` has found by the star of the same vertex. Takes no memory.
  template <class WhenHidden>
  void fill(std::uint32_t q, [[maybe_unused]] const WhenHidden& when_hidden) {
    new_cells_.clear();
    for (std::size_t k = 0; k < facets().size(); ++k) new_cells_.push_back(new_cell(k));
    star_.write(facets(), new_cells_, q);
    if constexpr (Signs::may_hide) {
      for (const std::uint32_t v : inner_) when_hidden(v);
    }
    for (std::size_t k = facets().size(); k < conflicts().size(); ++k) pool_.add(conflicts()[k]);
    last_ = new_cells_.back();
  }

  /// The cells that the last insertion made.
  std::span<const std::uint32_t> new_cells() const { return new_cells_; }

  /// Finds the cells in conflict with a vertex that is not inserted nor hidden, and marks them until `close` or `fill`.
  template <class Region>
  void find_conflicts(std::uint32_t q, const Region& region) {
    find_conflicts_at(locate(q, region), q, region);
  }
  /// The same where the cell is known that `locate` would find.
  template <class Region>
  void find_conflicts_at(std::uint32_t found, std::uint32_t q, const Region& region) {
    if (!open(found, q, region)) throw InternalError("a region does not own its cells");
  }
  void close() { conflict_.release(); }
  /// The cells in conflict, and what is between them and all others.
  std::span<const std::uint32_t> conflicts() const { return conflict_.cells(); }
  std::span<const HoleFacet> facets() const { return conflict_.facets(); }
  /// Vertices of cells in conflict that are on no facet between these and others: the vertex hides them. Ascending.
  std::span<const std::uint32_t> inner_vertices() const { return inner_; }

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
  static constexpr std::uint32_t mark = ConflictRegion3<Signs>::mark;

  /// Marks the cells in conflict and takes all memory that their replacement needs. False where a cell is not the
  /// region's, or there are too few for what comes; then, and where it throws, none is marked.
  template <class Region>
  bool open(std::uint32_t found, std::uint32_t q, const Region& region) {
    try {
      if (conflict_.find(found, q, region) && has_room_for_star<Region>()) {
        reserve<Region::may_grow>();
        if constexpr (Signs::may_hide) collect_vertices();
        return true;
      }
    } catch (...) {
      close();
      throw;
    }
    close();
    return false;
  }

  template <class Region>
  bool has_room_for_star() {
    has_room_ = Region::may_grow || facets().size() <= conflicts().size() + pool_.size();
    return has_room_;
  }

  /// For a star of as many cells as there are facets. What the pool has not comes from the end of the array.
  template <bool may_grow>
  void reserve() {
    new_cells_.reserve(facets().size());
    star_.reserve(facets().size());
    if (conflicts().size() > facets().size()) return pool_.reserve(conflicts().size() - facets().size());
    if constexpr (may_grow) {
      const std::size_t from_pool = conflicts().size() + pool_.size();
      if (facets().size() <= from_pool) return;
      const std::size_t size = cells_.size() + (facets().size() - from_pool);
      // Neighbours are four codes of 32 bits for each cell.
      if (size > most_cells) throw InputError("the triangulation has more than 2^30 cells");
      if (size > cells_.capacity()) cells_.reserve(std::max(size, 2 * cells_.capacity()));
    }
  }

  std::uint32_t new_cell(std::size_t k) {
    if (k < conflicts().size()) return conflicts()[k];
    if (pool_.size() > 0) return pool_.take();
    cells_.emplace_back();
    return static_cast<std::uint32_t>(cells_.size() - 1);
  }

  /// Of the cells that go, those on no facet of the hole: they are hidden afterwards.
  void collect_vertices() {
    inner_.clear();
    // All cells of such a vertex go, and it has four or more.
    if (conflicts().size() < 4) return;
    outer_.clear();
    numbers_.clear();
    const bool has_table = StarWriter::has_table(facets().size());
    for (const HoleFacet& facet : facets()) {
      for (const std::uint32_t v : facet.vertices) {
        if (has_table) {
          numbers_.number(v);
        } else {
          outer_.push_back(v);
        }
      }
    }
    std::sort(outer_.begin(), outer_.end());
    for (const std::uint32_t cell : conflicts()) {
      for (const std::uint32_t marked : cells_[cell].vertices) {
        const std::uint32_t v = marked & ~mark;
        // The vertex at infinity is hidden by none.
        if (v == vertex_at_infinity) continue;
        if (has_table ? !numbers_.has(v) : !std::binary_search(outer_.begin(), outer_.end(), v)) inner_.push_back(v);
      }
    }
    std::sort(inner_.begin(), inner_.end());
    inner_.erase(std::unique(inner_.begin(), inner_.end()), inner_.end());
  }

  const Signs& signs_;
  CellArray& cells_;
  CellPool pool_;
  bool has_room_ = true;
  StarWriter star_;
  ConflictRegion3<Signs> conflict_;
  std::vector<std::uint32_t> new_cells_;
  std::vector<std::uint32_t> inner_;
  std::vector<std::uint32_t> outer_;
  StarNumbers numbers_;
  std::uint32_t last_ = 0;
};

}  // namespace quoin
