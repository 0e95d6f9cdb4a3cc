// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// Which of some faces, given by their corners, have all of these on one line and are more than the surface needs,
/// ascending.
///
/// Such a face goes where most of its edges are used by an even number of others, so that the edges of odd use become
/// fewer; then the others are asked again, in the end together those that hang together. Where it joins an edge with
/// its parts, it stays. Exact; O(n log n).
std::vector<std::uint32_t> find_superfluous_slivers(const std::vector<Point3>& vertices,
                                                    const std::vector<std::vector<std::uint32_t>>& faces,
                                                    const Context& context);

}  // namespace quoin
