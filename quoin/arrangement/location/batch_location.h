// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "quoin/arrangement/location/location.h"

namespace quoin {

/// The cell that contains each of many points, by one sweep over the edges. Any surface.
///
/// Exact. O((n + q) log(n + q)) for n edges and q points, which may repeat. The points belong to the arrangement's
/// family and are not at infinity.
/// @throws Cancelled
template <CurveFamily F>
std::vector<Location> locate_batch(const Arrangement<F>& arrangement, std::span<const typename F::Point> points,
                                   const Context& context);

}  // namespace quoin
