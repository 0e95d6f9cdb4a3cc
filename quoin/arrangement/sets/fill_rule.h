// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace quoin {

/// What closed curves that overlap, cross themselves or run clockwise enclose.
enum class FillRule : std::uint8_t {
  even_odd,  ///< crossed an odd number of times on the way from outside
  nonzero,   ///< wound around, in either direction
  positive   ///< wound around counterclockwise more often than clockwise
};

}  // namespace quoin
