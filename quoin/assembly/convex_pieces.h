// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/polytope/polytope.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// Convex pieces whose union is the solid: its shells, each of which has to be convex.
///
/// This is the one place where solids become pieces; a general decomposition goes here.
/// @throws InputError  naming the solid: empty, unbounded, with a cavity, not convex (and at which edge), or with a
///                     vertex that is no point of doubles; Cancelled
std::vector<Polytope> convex_pieces(const Brep& boundary, const std::string& name, const Context& context);

}  // namespace quoin
