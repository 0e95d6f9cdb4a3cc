// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"

namespace quoin::overlay {

/// Tells voids from outer shells by the sign of the volume that each encloses, exactly, and counts the pieces of
/// material.
void orient_shells(Brep& brep, const Context& context);

}  // namespace quoin::overlay
