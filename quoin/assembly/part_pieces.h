// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/polytope/polytope.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// Convex pieces whose union is the solid: its components, cut into convex pieces where they are not convex
/// (decomposition.h). Exact. @throws InputError  naming the solid: empty or unbounded; Cancelled
std::vector<Polytope> pieces_of_part(const Brep& boundary, const std::string& name, const Context& context);

}  // namespace quoin
