// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/cell_array.h"
#include "quoin/triangulation/hidden_lists.h"
#include "quoin/triangulation/incremental3.h"

namespace quoin {

/// Takes all cells and facets, and now and then asks whether to go on.
class PollingRegion {
 public:
  static constexpr bool may_grow = true;

  explicit PollingRegion(const Context& context) : context_(context) {}
  bool owns(const std::array<std::uint32_t, 4>& /*cell*/) const { return step(); }
  bool owns_facet(std::uint32_t /*a*/, std::uint32_t /*b*/, std::uint32_t /*c*/) const { return step(); }

 private:
  bool step() const {
    if (++steps_ % 256 == 0) context_.poll();
    return true;
  }

  const Context& context_;
  mutable std::size_t steps_ = 0;
};

/// What fills the star of a vertex of a Delaunay or regular triangulation of space once the vertex has gone: the cells
/// of the triangulation of its neighbours, and of the points that are hidden in its star, that are in conflict with it.
/// As cells are determined by their vertices, ties included, these and no others are cells of the triangulation without
/// it: points hidden elsewhere stay so. Source: Devillers and Teillaud 2011.
template <class Signs>
class StarFilling3 {
 public:
  /// The signs may change between two calls of `find`.
  explicit StarFilling3(const Signs& signs) : signs_(signs), engine_(signs_, filling_) {}

  /// Of the vertex v of a cell `first`. False where all other points lie in one plane. O(d log d) expected for d
  /// neighbours and hidden points that are spread evenly, O(d^2) at worst. Changes nothing but this. @throws Cancelled
  bool find(const CellArray& cells, const HiddenLists& hidden, std::uint32_t v, std::uint32_t first,
            const Context& context);

  /// What has been found: cells that go, how many come, some neighbour, and the hidden points that become vertices.
  std::span<const std::uint32_t> star() const { return star_; }
  std::size_t size() const { return fill_.size(); }
  std::uint32_t neighbour() const { return points_.front(); }
  std::span<const std::uint32_t> shown() const { return engine_.inner_vertices(); }
  /// Writes these to such places, which may be those of the star, and links them. Takes no memory.
  void write(CellArray& cells, std::span<const std::uint32_t> places) const;

 private:
  /// A facet between the hole and what is around it, named by the directed edge from its smallest vertex, and the slot
  /// opposite to it on one side.
  struct Side {
    std::uint64_t edge;
    std::uint32_t code;
  };
  static Side side(const std::array<std::uint32_t, 3>& facet, std::uint32_t code);
  static void sort(std::vector<Side>& sides);

  void add_hidden(const HiddenLists& hidden, const Context& context);
  void read_hole(const CellArray& cells, std::uint32_t v);
  bool choose_simplex(const CellArray& cells, std::uint32_t v, const Context& context);
  void triangulate(const Context& context);
  void insert_in_rounds(const Context& context);
  void insert(std::uint32_t v, const PollingRegion& region);
  void read_filling(std::uint32_t v, const Context& context);

  const Signs& signs_;
  CellArray filling_;  ///< the triangulation of the points
  IncrementalTriangulation<Signs> engine_;
  std::vector<std::uint32_t> star_;
  std::vector<std::uint32_t> points_;  ///< neighbours, and then hidden ones
  std::array<std::uint32_t, 4> simplex_{};
  std::vector<Side> outside_;
  std::vector<Side> inside_;
  std::vector<std::uint32_t> fill_;    ///< cells of `filling_`
  std::vector<std::uint32_t> number_;  ///< of each cell of `filling_` among these, or no_vertex
};

}  // namespace quoin
