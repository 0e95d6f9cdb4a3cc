// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// Volume enclosed by the boundary, in cubic units; exact. Negative for the boundary of an unbounded set: minus the
/// volume left out.
///
/// A rational whose length grows with the number of constructed vertices: O(n) terms, added pairwise in a tree.
Rational volume(const Brep& boundary, const Context& context);

/// The same, correctly rounded to the nearest double: fixed-point sums with a bound on their error, widened until
/// the rounding is certain. Fast for any size.
double rounded_volume(const Brep& boundary, const Context& context);

/// Centroid of the enclosed set; exact, at the cost of `volume`. Nothing when the volume is zero.
std::optional<RationalPoint3> centroid(const Brep& boundary, const Context& context);

/// Vector along the outward normal whose length is the area of the face; exact.
RationalPoint3 area_vector(const Brep& boundary, std::uint32_t face);

/// Sum of the lengths of the area vectors, each with a relative error below 2^-51 (subnormal ones: an error below two
/// of their units); infinite beyond the largest double.
double surface_area(const Brep& boundary, const Context& context);

/// Smallest box around the boundary, by its corners; rounded coordinates, so nearest doubles of the exact box. Nothing
/// without faces.
struct Bounds {
  Point3 lo;
  Point3 hi;
};
std::optional<Bounds> bounds(const Brep& boundary);

/// The same, exact. There is a face.
struct ExactBox {
  RationalPoint3 lo;
  RationalPoint3 hi;

  /// Larger by `margin` on all sides, in each coordinate.
  ExactBox grown(const RationalPoint3& margin) const { return {lo - margin, hi + margin}; }
  ExactBox moved(const RationalPoint3& by) const { return {lo + by, hi + by}; }
  bool contains(const RationalPoint3& p) const;
  void extend(const RationalPoint3& p);
};
ExactBox exact_bounds(const Brep& boundary);

}  // namespace quoin
