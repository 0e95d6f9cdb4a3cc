// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "quoin/base/context.h"
#include "quoin/polytope/tiled_surface.h"
#include "quoin/solid/leaf.h"

namespace quoin {

/// The convolution of two boundaries as a closed surface that may cross itself, ready for an overlay.
///
/// It is made of the tiles of either surface, each at the vertices of the other that are critical in the direction of
/// its normal, and of parallelograms of edges whose arcs cross on the sphere; each as often, and turned over, as
/// products of signs say. It winds about a point t as often as the Euler number of what the first solid has in common
/// with the second one reflected and placed at t. So where it winds, t lies in the sum; where it does not, t may lie in
/// the sum too, if they meet in a ring.
///
/// Exact: coordinates are sums, rational where doubles do not hold them. Ties between parallel parts are decided by one
/// infinitesimal rotation of the second. Complexity: as arc_crossings, and linear in the result.
/// Source: Guibas, Ramshaw and Stolfi 1983; Schapira 1991 (Euler numbers).
/// @throws InputError where sums leave the range of doubles, Cancelled
std::shared_ptr<const Leaf> convolution(const TiledSurface& a, const TiledSurface& b, const Context& context);

}  // namespace quoin
