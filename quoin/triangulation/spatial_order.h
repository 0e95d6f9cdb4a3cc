// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// All points, by their indices, along a Hilbert curve; points of one cell of the curve along a finer curve of their
/// own, and the last few by their coordinates. Equal points follow each other, the one given first first.
///
/// The order of distinct points depends on their set alone, not on the order in which they are given or how often. At
/// most 2^31 finite points. O(n) for points whose distances are of like size; at most O(n log n) per 11 bits that they
/// span.
std::vector<std::uint32_t> hilbert_order(std::span<const Point3> points, const Context& context);

}  // namespace quoin
