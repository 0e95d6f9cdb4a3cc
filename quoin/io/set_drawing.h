// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "quoin/arrangement/circular/circular_polygon_set.h"
#include "quoin/arrangement/linear/linear_polygon_set.h"
#include "quoin/base/context.h"
#include "quoin/io/drawing.h"

namespace quoin {

/// A set as polygons in doubles, and what rounding did.
struct SetDrawing {
  Drawing drawing;
  double max_displacement = 0;     ///< of a vertex, at most; 0: every vertex is a pair of doubles
  unsigned rounds = 0;             ///< how often rounding made boundaries meet that had to be taken apart again
  std::size_t vanished_rings = 0;  ///< rings that rounding left without area
};

/// The polygons of a bounded set with vertices rounded to the nearest doubles. The result is certified: where rounding
/// makes boundaries meet or cross, the region they wind around is taken instead and rounded again, until nothing
/// changes.
/// @throws InputError if the set is unbounded, or if 16 rounds do not settle it
SetDrawing draw_set(const LinearPolygonSet& set, const Context& context);

/// Edges on circles become bulges, rounded too. Whether rounded arcs stay apart is not checked.
SetDrawing draw_set(const CircularPolygonSet& set, const Context& context);

}  // namespace quoin
