// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/solid/overlay/overlay.h"
#include "quoin/solid/overlay/truth.h"

namespace quoin::overlay {

/// Asks for each cell of a complex of one leaf, the unbounded one included, whether it is inside. Far away is outside.
CellTruth classify_winding_cells(const Sheets& sheets, const CellComplex& complex, const CellMembership& is_inside,
                                 const Context& context);

}  // namespace quoin::overlay
