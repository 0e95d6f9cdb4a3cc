// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/box.h"
#include "quoin/polytope/polytope.h"

namespace quoin {

/// A rigid part of an assembly: the union of convex pieces, which may overlap.
struct AssemblyPart {
  std::string name;
  std::vector<Polytope> pieces;
  std::vector<Polytope> reflected;  ///< each piece times -1
  std::vector<Box3> piece_boxes;
  Box3 box;
  double map_seconds = 0;         ///< time that the pieces' Gaussian maps took, where it is known
  double reflection_seconds = 0;  ///< and their reflections
};

/// @throws InputError naming the part: no piece, or a flat one; Cancelled
AssemblyPart make_part(std::string name, std::vector<Polytope> pieces, const Context& context);

/// @throws InputError  no parts, or two of one name
void require_distinct_parts(std::span<const AssemblyPart> parts);

}  // namespace quoin
