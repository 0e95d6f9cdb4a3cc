// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/float_box.h"

namespace quoin {

/// Boxes along a space-filling curve.
struct MortonOrder {
  std::vector<std::uint32_t> keys;   ///< 30 bits, ascending
  std::vector<std::uint32_t> order;  ///< the box that has the key
};

/// Order of the centres of boxes, none of them empty, within `all`. Its quality matters to trees built on it, not its
/// exactness; it depends on the boxes alone. O(n).
MortonOrder morton_order(std::span<const FloatBox> boxes, const FloatBox& all, const Context& context);

}  // namespace quoin
