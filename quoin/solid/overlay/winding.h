// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/kernel/rational_point.h"
#include "quoin/solid/overlay/fans.h"

namespace quoin::overlay {

/// The leaves that wind about the points just before or just behind a sheet, those with number 0 left out.
struct SheetWinding {
  bool in_front;  ///< it speaks of the side the sheet's normal points to
  std::vector<Winding> windings;
};

/// A point strictly inside a sheet. O(n) for a region with n vertices, in rationals for regions.
RationalPoint3 interior_point(const Sheets& sheets, std::uint32_t sheet);

/// Counts, exactly and for all leaves, the tiles above the sheet on a line through its interior point along the axis of
/// its largest normal component. The line is moved by an infinitesimal that no edge can hit; sheets that overlap the
/// given one do not count. O(log n + tiles near the line) per leaf near the line.
SheetWinding winding_at(const Sheets& sheets, std::uint32_t sheet);

}  // namespace quoin::overlay
