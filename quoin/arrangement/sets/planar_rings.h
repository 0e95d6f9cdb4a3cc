// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "quoin/arrangement/linear/linear_polygon_set.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/rational_point.h"

/// Boundaries of sets as rings of exact points, for constructions on them.
namespace quoin::planar {

/// A point in doubles where doubles say it, rational otherwise.
struct PlanarPoint {
  Point2 rounded;
  std::optional<RationalPoint2> rational{};  ///< nothing: `rounded` is the point

  bool is_double() const { return !rational.has_value(); }
  RationalPoint2 exact() const { return rational ? *rational : RationalPoint2{rounded.x, rounded.y}; }
};

/// Doubles if they are exact.
PlanarPoint planar_point(const RationalPoint2& point);
/// The vector sum, exact.
PlanarPoint sum(const PlanarPoint& a, const PlanarPoint& b);
BranchId add_line(LinearFamily& family, const PlanarPoint& a, const PlanarPoint& b);
LinearFamily::Point add_point(LinearFamily& family, const PlanarPoint& point);

/// From one point to another one.
class Direction {
 public:
  Direction(const PlanarPoint& from, const PlanarPoint& to);

  /// Counterclockwise order from the positive x axis on, in [0, 360) degrees; exact.
  static Sign compare(const Direction& a, const Direction& b);
  /// Positive: b is to the left of a.
  static Sign turn(const Direction& a, const Direction& b);
  bool is_lexicographically_negative() const { return x_ == Sign::negative || (x_ == Sign::zero && is_lower_); }

 private:
  static Sign exact_turn(const Direction& a, const Direction& b);

  const PlanarPoint* from_;
  const PlanarPoint* to_;
  double dx_ = 0;  // within u of themselves, or not finite where no double says them
  double dy_ = 0;
  bool is_exact_ = false;
  bool is_lower_ = false;  // half-open: angles in [180, 360)
  Sign x_ = Sign::zero;
};

/// A simple closed polygon, the set on its left: its vertices in order, none straight.
struct PlanarRing {
  std::vector<PlanarPoint> points;
  bool is_hole = false;
};
/// A part of a set with connected interior: its outer ring, then its holes.
struct PlanarComponent {
  std::vector<PlanarRing> rings;
};

/// The regularized set. @throws InputError that names the set if it is unbounded
std::vector<PlanarComponent> components_of(const LinearPolygonSet& set, const char* name);

/// Sides of the bounding box of a ring.
struct Extent {
  Rational width;
  Rational height;
  /// A box of this extent fits into one of that extent, walls touching allowed.
  bool fits_into(const Extent& other) const { return width <= other.width && height <= other.height; }
};
Extent extent_of(const PlanarRing& ring);

}  // namespace quoin::planar
