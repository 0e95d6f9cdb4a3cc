// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace quoin {

/// Vertices whose numbers follow each other, the first after the last one: a part of a space-filling curve. One thread
/// inserts the points of such a region while others insert those of others.
///
/// A region owns the cells of which it has three vertices or more, and the facets of which it has two or more. So
/// no two own the same, all facets of a cell are its owner's, and cells of two owners are never neighbours: those
/// between them are nobody's. A region replaces cells of its own alone, by cells that are its own again, and changes
/// the links of its facets alone; of cells that are nobody's the vertices stay. Thus threads share nothing that
/// changes.
struct RankRegion {
  static constexpr bool may_grow = false;  ///< the array of cells, which is everybody's

  std::uint32_t begin = 0;
  std::uint32_t length = 0;
  std::uint32_t cycle = 0;  ///< more than the largest number of a vertex

  /// Modulo 2^32 and the cycle; the vertex at infinity is far beyond all others.
  std::uint32_t steps_to(std::uint32_t v) const { return std::min(v - begin, v - begin + cycle); }
  bool contains(std::uint32_t v) const { return steps_to(v) < length; }
  /// Its vertices, as they follow each other.
  std::array<std::array<std::uint32_t, 2>, 2> runs() const {
    const std::uint32_t end = begin + length;
    return {{{begin, std::min(end, cycle)}, {0, end > cycle ? end - cycle : 0}}};
  }
  bool owns(const std::array<std::uint32_t, 4>& cell) const {
    unsigned inside = 0;
    for (const std::uint32_t v : cell) inside += contains(v) ? 1 : 0;
    return inside >= 3;
  }
  bool owns_facet(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return unsigned{contains(a)} + unsigned{contains(b)} + unsigned{contains(c)} >= 2;
  }
};

/// Part `r` of so many of equal length into which a cycle is divided, the first of which begins at this part of it.
inline RankRegion part_of_cycle(std::uint32_t cycle, std::size_t parts, double begin, std::size_t r) {
  const auto bound = [&](std::size_t i) {
    return static_cast<std::uint32_t>((begin + static_cast<double>(i) / static_cast<double>(parts)) *
                                      static_cast<double>(cycle));
  };
  const std::uint32_t end = r + 1 < parts ? bound(r + 1) : bound(0) + cycle;
  return {bound(r) % cycle, end - bound(r), cycle};
}

/// Where one thread does all.
struct WholeRegion {
  static constexpr bool may_grow = true;

  static constexpr bool owns(const std::array<std::uint32_t, 4>& /*cell*/) { return true; }
  static constexpr bool owns_facet(std::uint32_t /*a*/, std::uint32_t /*b*/, std::uint32_t /*c*/) { return true; }
};

}  // namespace quoin
