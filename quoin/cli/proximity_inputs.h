// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/polytope/polytope.h"
#include "quoin/solid/solid.h"

namespace quoin::cli {

/// One of two solids whose distance is asked for.
struct ProximityOperand {
  std::string name;
  std::optional<Solid> solid;                   ///< nothing of points without faces
  std::shared_ptr<const Brep> boundary;         ///< null of points in a plane
  std::optional<std::vector<Polytope>> pieces;  ///< where all are convex, with vertices that are doubles
  bool is_convex() const { return pieces && pieces->size() == 1; }
};

/// Points without faces mean their hull, which may be flat. @throws InputError of what bounds no solid, or is empty
ProximityOperand read_proximity_operand(const std::string& name, const Options& options,
                                        std::vector<std::string>& warnings, const Context& context);

/// As a solid. @throws InputError of points in a plane
Solid solid_of(const ProximityOperand& operand, const Context& context);

/// A rational vector, if it is one of doubles.
std::optional<Vector3> as_doubles(const RationalPoint3& v);

}  // namespace quoin::cli
