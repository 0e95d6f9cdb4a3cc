// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// By shell, the number of the piece of material that it bounds: a cavity has that of the shell around its material.
///
/// Numbers are those of the pieces in the order of their first shells, 0 for the piece that reaches infinity where the
/// solid is unbounded; there are `component_count` of them. Exact; pieces that touch stay apart. O(n) without cavities
/// or with one piece, else O(n log n) and O(log n + k log k) more per cavity, whose line crosses k faces.
std::vector<std::uint32_t> components_of_shells(const Brep& boundary, const Context& context);

/// The pieces of material of a bounded solid, in the order of their numbers, each over the exact points that it needs.
/// Exact, cost as above and O(n). @throws InputError  the solid is unbounded
std::vector<Brep> component_boundaries(const Brep& boundary, const Context& context);

}  // namespace quoin
