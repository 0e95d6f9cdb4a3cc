// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/solid/leaf.h"

namespace quoin {

/// Fills `twins` of the leaf and notes open, misoriented and nonmanifold edges. O(n).
void match_twins(Leaf& leaf, std::size_t max_listed, MeshDiagnosis& diagnosis, const Context& context);

}  // namespace quoin
