// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/solid/overlay/sheets.h"

namespace quoin::overlay {

/// A point strictly inside the cell before (or behind) a sheet, near the sheet and with few digits: binary fractions
/// where the room around the sheet's interior point lets them be.
///
/// Exact: the ball around that point up to the nearest tile that does not hold it meets nothing but the sheet's plane.
/// O(tiles), and O(log tiles) for each that is measured (nearest_tile.h).
RationalPoint3 point_near_sheet(const Sheets& sheets, std::uint32_t sheet, bool in_front, const Context& context);

}  // namespace quoin::overlay
