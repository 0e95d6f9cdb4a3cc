// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/sheets.h"

namespace quoin::overlay {

void windings_across(const Sheets& sheets, std::uint32_t sheet, std::vector<Winding>& out) {
  out.clear();
  if (!sheets.is_region(sheet)) {
    out.push_back({sheets.leaf(sheet), 1});
    return;
  }
  const Clusters& clusters = sheets.network->clusters;
  windings_across(*sheets.scene, clusters, sheets.subdivision->covers_of(sheets.region(sheet)), out);
  if (!clusters.is_reversed[sheets.facet(sheet)]) return;
  for (Winding& w : out) w.number = -w.number;
}

CoverSides sides_of_covers(const Sheets& sheets, std::uint32_t sheet) {
  if (!sheets.is_region(sheet)) return {true, false};
  const std::vector<bool>& is_reversed = sheets.network->clusters.is_reversed;
  CoverSides sides{false, false};
  for (const std::uint32_t facet : sheets.subdivision->covers_of(sheets.region(sheet))) {
    (is_reversed[facet] == is_reversed[sheets.facet(sheet)] ? sides.front : sides.back) = true;
  }
  return sides;
}

bool in_one_plane(const Sheets& sheets, std::uint32_t a, std::uint32_t b) {
  if (sheets.tile(a) == sheets.tile(b)) return true;
  const std::array<PointId, 3> p = sheets.corners(a);
  for (const PointId q : sheets.corners(b)) {
    if (q == p[0] || q == p[1] || q == p[2]) continue;
    if (sheets.scene->table.orientation(p[0], p[1], p[2], q) != Sign::zero) return false;
  }
  return true;
}

}  // namespace quoin::overlay
