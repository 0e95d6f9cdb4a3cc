// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

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
  /// Facet of a sheet, or none for a tile that is no facet; it gives the sheet's plane and orientation.
  std::uint32_t facet(std::uint32_t sheet) const {
    return is_region(sheet) ? subdivision->region_facet[region(sheet)] : scene->facet_of_tile[sheet];
  }
  std::uint32_t tile(std::uint32_t sheet) const { return is_region(sheet) ? scene->facets[facet(sheet)].tile : sheet; }
  /// The leaf of a tile, or of the first facet that covers a region.
  std::uint32_t leaf(std::uint32_t sheet) const {
    if (is_region(sheet)) return scene->facets[subdivision->covers_of(region(sheet))[0]].leaf;
    const std::uint32_t f = scene->facet_of_tile[sheet];
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

/// Calls visit(point) for the corners of a tile, or for all vertices of a region's loops, some of them several times.
template <class Visit>
void for_each_vertex(const Sheets& sheets, std::uint32_t sheet, const Visit& visit) {
  if (!sheets.is_region(sheet)) {
    for (const PointId p : sheets.corners(sheet)) visit(p);
    return;
  }
  const Subdivision& cut = *sheets.subdivision;
  const std::uint32_t region = sheets.region(sheet);
  for (std::uint32_t l = cut.region_first_loop[region]; l < cut.region_first_loop[region + 1]; ++l) {
    for (const PointId p : cut.loop(l)) visit(p);
  }
}

/// By how much the winding numbers change from the front of a sheet to its back: +1 for each tile it is part of, -1
/// where that tile has the opposite normal. Ascending by leaf, none of them 0.
void windings_across(const Sheets& sheets, std::uint32_t sheet, std::vector<Winding>& out);

/// Which ways the normals of the tiles point that a sheet is part of.
struct CoverSides {
  bool front;  ///< of one at least, as that of the sheet
  bool back;   ///< of one at least, the other way
};
CoverSides sides_of_covers(const Sheets& sheets, std::uint32_t sheet);

/// Whether two sheets lie in one plane, exactly.
bool in_one_plane(const Sheets& sheets, std::uint32_t a, std::uint32_t b);

}  // namespace quoin::overlay
