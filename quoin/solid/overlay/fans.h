// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/overlay/subdivision.h"

namespace quoin::overlay {

/// The pieces of surface that the overlay consists of, in one numbering: whole tiles, then regions of cut facets.
struct Sheets {
  const Scene* scene;
  const Network* network;
  const Subdivision* subdivision;

  std::size_t tile_count() const { return scene->tile_count(); }
  std::size_t count() const { return tile_count() + subdivision->region_count(); }
  bool is_region(std::uint32_t sheet) const { return sheet >= tile_count(); }
  std::uint32_t region(std::uint32_t sheet) const { return sheet - static_cast<std::uint32_t>(tile_count()); }
  /// Facet of a sheet, or none for a tile that is no facet.
  std::uint32_t facet(std::uint32_t sheet) const {
    return is_region(sheet) ? subdivision->region_facet[region(sheet)] : scene->facet_of_tile[sheet];
  }
  std::uint32_t tile(std::uint32_t sheet) const { return is_region(sheet) ? scene->facets[facet(sheet)].tile : sheet; }
  std::uint32_t leaf(std::uint32_t sheet) const {
    const std::uint32_t f = facet(sheet);
    return f != none ? scene->facets[f].leaf : scene->leaf_of_tile(sheet);
  }
  std::array<PointId, 3> corners(std::uint32_t sheet) const {
    const std::uint32_t f = facet(sheet);
    return f != none ? scene->facets[f].corners : scene->corners(sheet, scene->leaf_of_tile(sheet));
  }
  /// The tile was cut: its regions stand for it.
  bool is_replaced(std::uint32_t tile) const {
    const std::uint32_t f = scene->facet_of_tile[tile];
    return f != none && network->cut[f];
  }
};

/// A sheet at an edge that it bounds; `forward` when the sheet lies to the left of the edge from its smaller to its
/// larger end.
struct Side {
  PointId from;  ///< smaller
  PointId to;
  std::uint32_t sheet;
  bool forward;
  std::uint32_t rank = 0;  ///< place in the fan; overlapping sheets share one
};

/// All sides at one edge, counterclockwise about the direction from its smaller to its larger end.
struct Fan {
  std::uint32_t first;
  std::uint32_t count;
  bool is_plain;  ///< two sides of one leaf, as in any surface
};

/// The edges at which sheets of several leaves may meet, with their sides in radial order.
struct Fans {
  std::vector<Side> sides;
  std::vector<Fan> fans;

  std::span<const Side> sides_of(const Fan& fan) const { return {sides.data() + fan.first, fan.count}; }
};

/// Gathers the sides of all involved facets and orders them about their edges, exactly. O(s log s) for s sides.
Fans make_fans(const Sheets& sheets, Scene& scene, const Context& context);

/// Whether two sheets lie in one plane, exactly.
bool in_one_plane(const Sheets& sheets, std::uint32_t a, std::uint32_t b);

}  // namespace quoin::overlay
