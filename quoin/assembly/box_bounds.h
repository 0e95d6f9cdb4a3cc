// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "quoin/assembly/projection.h"
#include "quoin/base/context.h"
#include "quoin/kernel/box.h"

namespace quoin {

/// The directions in which a box moving to infinity would meet the inside of another one: outside of them nothing in
/// the first meets anything in the second. Nothing where the boxes have a common interior point. Exact.
/// @throws Cancelled
std::optional<ConvexRegion> project_boxes(const Box3& moving, const Box3& other, const Context& context);

/// Whether what is in the first box meets what is in the second in directions of one of the regions at most. Says yes
/// only where it is sure: boxes that are strictly apart, and all differences of their corners clearly inside.
/// O(regions).
bool are_surely_covered(const Box3& moving, const Box3& other, std::span<const ConvexRegion> regions);

}  // namespace quoin
