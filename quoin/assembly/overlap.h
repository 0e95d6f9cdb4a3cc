// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "quoin/assembly/pair_regions.h"
#include "quoin/number/rational.h"
#include "quoin/solid/solid.h"

namespace quoin {

/// A part as one solid, the union of its pieces. @throws Cancelled
Solid solid_of(const AssemblyPart& part, const Context& context);

/// The volume that two parts have in common, exact. Costs a Boolean of their pieces. @throws Cancelled
Rational common_volume(const AssemblyPart& a, const AssemblyPart& b, const Context& context);

/// "a and b overlap in a volume of 1/2", a line for each pair, at most `most` of them. @throws Cancelled
std::string describe_overlaps(std::span<const AssemblyPart> parts, std::span<const OverlappingParts> overlaps,
                              std::size_t most, const Context& context);

}  // namespace quoin
