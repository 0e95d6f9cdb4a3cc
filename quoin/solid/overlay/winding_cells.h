// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/solid/overlay/overlay.h"
#include "quoin/solid/overlay/truth.h"

namespace quoin::overlay {

/// The cells of a kind in the set of winding_boundary (overlay.h).
CellTruth classify_winding_cells(const Sheets& sheets, const CellComplex& complex, CellVerdict kind,
                                 const CellQuestion& question, const Context& context);

}  // namespace quoin::overlay
