// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/overlay/truth.h"

namespace quoin::overlay {

/// The boundary of the cells inside: sheets between a cell inside and one outside, merged to maximal faces.
///
/// Coplanar neighbours with the same outward side and colour become one face; a vertex where only two collinear edges
/// meet is dropped. O(sheets log sheets). Each connected piece of bounded material has just one shell
/// that is no void, which is how they are counted.
Brep extract_boundary(const Sheets& sheets, const Fans& fans, const CellComplex& complex, const CellTruth& truth,
                      const Context& context);

}  // namespace quoin::overlay
