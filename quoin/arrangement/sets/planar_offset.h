// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/circular/circular_polygon_set.h"
#include "quoin/arrangement/linear/linear_polygon_set.h"
#include "quoin/number/rational.h"

namespace quoin {

struct PlanarOffsetOptions {
  /// How far the radius may be off where the normals of edges are irrational; 0: a millionth of it (2^-20).
  Rational bound{0};
};

/// Sets with straight edges and circular arcs that enclose an offset. With D(r) the exact offset of radius r,
///   D(radius - bound) <= inner <= D(radius) <= outer <= D(radius + bound)
/// for offsets, the other way around in the radius for insets.
struct PlanarOffset {
  CircularPolygonSet inner;
  CircularPolygonSet outer;
  bool is_exact = false;  ///< both are the offset; so where all edges have rational lengths
  Rational bound;         ///< 0 if exact
};

/// All points at most `radius` away from a bounded set, which is regularized first; closed and regular.
///
/// The boundary is drawn as one chain per ring: every edge moved by its outer normal, arcs about convex vertices, and
/// at reflex ones straight to the vertex and back. It is the sum of the boundaries of the set, of a rectangle on each
/// edge and of a sector at each convex vertex, so that it winds around every point as often as these cover it. Where a
/// normal is irrational, two rational unit vectors enclose it, the rectangle is a trapezoid that leans out at both
/// ends: within the discs about the ends for the inner set, over the rectangle for the outer one, whose radius is
/// larger. O((n + k) log n) for n vertices and k crossings of the chains.
/// @throws InputError  the set is unbounded, the radius not positive or the bound negative, or numbers are out of the
///                     range of CircularFamily; Cancelled
PlanarOffset offset(const LinearPolygonSet& set, const Rational& radius, const PlanarOffsetOptions& options,
                    const Context& context);
/// The same; the radius must be finite.
PlanarOffset offset(const LinearPolygonSet& set, double radius, const PlanarOffsetOptions& options,
                    const Context& context);

/// All points of a bounded set that are at least `radius` away from its complement, regularized: what is too thin
/// vanishes, which may be everything. The set is regularized first.
/// @throws as `offset`
PlanarOffset inset(const LinearPolygonSet& set, const Rational& radius, const PlanarOffsetOptions& options,
                   const Context& context);
PlanarOffset inset(const LinearPolygonSet& set, double radius, const PlanarOffsetOptions& options,
                   const Context& context);

}  // namespace quoin
