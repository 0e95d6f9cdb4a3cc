// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "quoin/kernel/rational_point.h"
#include "quoin/number/integer.h"
#include "quoin/polytope/cube_squares.h"
#include "quoin/polytope/map_arcs.h"

/// Parts of arcs of great circles on the squares of a cube.
namespace quoin::cube {

using Direction = std::array<Integer, 3>;

/// The part of an arc on one square: a segment between two points of it.
struct Part {
  RationalPoint2 from;
  RationalPoint2 to;
  bool has_source = false;  ///< it begins where the arc does
  bool has_target = false;  ///< it ends where the arc does
};

/// Cuts arcs of a map at the sides of squares. Exact.
class Clipping {
 public:
  /// The map must outlive it.
  explicit Clipping(const MapArcs& map);

  /// The part of an arc on a square, unless it is no more than a point or nothing.
  std::optional<Part> on_square(std::size_t arc, std::size_t square) const;

 private:
  const MapArcs& map_;
  std::vector<Direction> normals_;
};

}  // namespace quoin::cube
