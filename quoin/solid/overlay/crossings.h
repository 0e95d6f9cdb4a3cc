// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/overlay/network.h"

namespace quoin::overlay {

/// A vertex strictly inside a curve, by the curve's index in the network.
struct PointOnCurve {
  std::uint32_t curve;
  PointId point;
  friend auto operator<=>(const PointOnCurve&, const PointOnCurve&) = default;
};

/// Finds where the curves of each facet cross, touch and overlap; new vertices are meets of three planes.
///
/// O(k log k + pairs of curves whose boxes meet) per facet with k curves. Sorted, unique.
std::vector<PointOnCurve> find_crossings(Scene& scene, Network& network, const Context& context);

}  // namespace quoin::overlay
