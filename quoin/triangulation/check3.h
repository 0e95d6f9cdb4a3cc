// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "quoin/base/context.h"
#include "quoin/triangulation/delaunay3.h"

namespace quoin {

/// What is wrong with a Delaunay triangulation of points of space, or nothing (the empty string): a certificate that
/// needs no trust in how it was made, by the predicates of the kernel.
///
/// Neighbours are mutual and share their facet, cells are positively oriented (in a plane, all alike), the hull is
/// convex, the sphere or circle of every cell has no vertex of a neighbour inside (then it has none at all inside;
/// Delaunay 1934), and every given point lies at one vertex that names it. Of a line, cells are consecutive points. O(n
/// log n), exact. @throws Cancelled
std::string defect(const Delaunay3& delaunay, std::span<const Point3> inputs, const Context& context);

/// The same about cells of distinct points; those are numbered as `points` are.
std::string defect_of_cells(std::span<const TriangulationCell> cells, int dimension, std::span<const Point3> points,
                            const Context& context);

}  // namespace quoin
