// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/solid.h"

namespace quoin {

/// What a bounded solid leaves of a box about it, so large that whatever has the size of `reach` and a point in the
/// solid lies well inside. Exact. @throws InputError  the solid is unbounded
Solid complement_in_box(const Solid& solid, const ExactBox& reach, const Context& context);

}  // namespace quoin
