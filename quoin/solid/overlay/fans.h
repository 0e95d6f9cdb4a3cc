// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/overlay/sheets.h"

namespace quoin::overlay {

/// A sheet at an edge that it bounds; `forward` when the sheet lies to the left of the edge from its smaller to its
/// larger end.
struct Side {
  PointId from;  ///< smaller
  PointId to;
  std::uint32_t sheet;
  bool forward;
  std::uint32_t rank = 0;  ///< place in the fan; overlapping sheets share one
};

/// All sides at one edge, counterclockwise about the direction from its smaller to its larger end.
struct Fan {
  std::uint32_t first;
  std::uint32_t count;
  bool is_plain;  ///< two sides of one leaf, as in any surface
};

/// The edges at which sheets of several leaves may meet, with their sides in radial order.
struct Fans {
  std::vector<Side> sides;
  std::vector<Fan> fans;

  std::span<const Side> sides_of(const Fan& fan) const { return {sides.data() + fan.first, fan.count}; }
};

/// Gathers the sides of all involved facets and orders them about their edges, exactly. O(s log s) for s sides.
Fans make_fans(const Sheets& sheets, Scene& scene, const Context& context);

}  // namespace quoin::overlay
