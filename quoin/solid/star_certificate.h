// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/leaf.h"

namespace quoin {

/// Per vertex, whether it is certain that the tiles around it meet in nothing but the vertex and their shared edges.
///
/// Seen along the sum d of the tiles' normals, the star of such a vertex is a fan that turns just once: every tile (v,
/// a, b) has det(a - v, b - v, d) > 0, and just one of them crosses the half-line along which turning is counted. The
/// determinants are certain by a filter, the crossings exact; where a determinant is not certain, the vertex is not
/// certified, so a certificate decides which tests are run, never a result. Over rational points no vertex is. Only
/// vertices that are wanted (not 0, one entry per vertex) are looked at. O(n).
std::vector<std::uint8_t> certify_stars(const Leaf& leaf, std::span<const std::uint8_t> wanted, const Context& context);

}  // namespace quoin
