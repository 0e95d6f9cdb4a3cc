// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/solid/leaf.h"

namespace quoin {

/// Notes a one-sided band of faces of each component of the leaf that no orientation fits, components being joined
/// across edges of two tiles. O(n log n).
void find_one_sided_bands(const Leaf& leaf, std::size_t max_listed, MeshDiagnosis& diagnosis, const Context& context);

}  // namespace quoin
