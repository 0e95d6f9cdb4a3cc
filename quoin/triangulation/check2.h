// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "quoin/base/context.h"
#include "quoin/triangulation/delaunay2.h"

namespace quoin {

/// What is wrong with a Delaunay triangulation, or nothing (the empty string): a certificate that needs no trust in how
/// it was made.
///
/// Links are mutual and make a sphere, finite triangles turn counterclockwise, the hull is convex, the circle of every
/// triangle has no corner of a neighbour inside (then it has no point inside; Delaunay 1934), and every given point
/// lies at one vertex that names it. In dimension 0 and 1 all points lie on one line, in order. O(n), exact. @throws
/// Cancelled
std::string defect(const Delaunay2& delaunay, std::span<const Point2> inputs, const Context& context = Context());

}  // namespace quoin
