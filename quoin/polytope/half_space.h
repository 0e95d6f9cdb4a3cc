// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/query/section.h"
#include "quoin/solid/solid.h"

namespace quoin {

/// The part of the box on or below the plane, where normal . x <= offset; empty where it has no volume. Exact, O(1).
/// The box has a volume.
Solid half_space_in_box(const ExactBox& box, const SectionPlane& plane, const Context& context);

/// All of it.
Solid solid_box(const ExactBox& box, const Context& context);

}  // namespace quoin
