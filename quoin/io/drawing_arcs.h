// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "quoin/io/drawing.h"

/// Circular arcs as files give them, as bulges (drawing.h).
///
/// All bounds rest on one fact: arcs over one chord of half length h with bulges p and q are h |p - q| apart
/// (Hausdorff), the distance of their tops. With the chord's ends at -h and h, w = (z - h) / (z + h) maps each such arc
/// to a ray from zero; turning the ray by an angle moves z(w) fastest at |w| = 1, the top, and the top moves straight
/// on.
namespace quoin::io {

/// The double next to the bulge of an arc.
struct RoundedBulge {
  double bulge = 0;
  double distance = 0;       ///< bound of the distance between the arc and that of the double; 0 if it is the same
  double radius_change = 0;  ///< bound for the radius, where the arc came with one
};

/// The arc from a through m to b, a != b. Nothing where m is on their line, but not between them, or where the bulge is
/// beyond the largest double.
std::optional<RoundedBulge> bulge_through(const Point2& a, const Point2& m, const Point2& b);

/// The arc of this radius from a to b, a != b, radius > 0: with `is_large` the one beyond half a circle,
/// counterclockwise or clockwise. Where the radius is too short it is half the chord. Nothing where the bulge is beyond
/// the largest double.
std::optional<RoundedBulge> bulge_of_radius(const Point2& a, const Point2& b, double radius, bool is_large,
                                            bool is_counterclockwise);

/// An arc by centre, radius and angles, with its ends as nearest doubles.
struct RoundedArc {
  Point2 start;
  Point2 end;
  double bulge = 0;
  bool is_whole = false;  ///< the whole circle
  double distance = 0;    ///< bound of the distance between the arc and what this stands for
};

/// Counterclockwise between two angles in degrees, at most once around; equal angles are the whole circle. Where
/// rounding makes the ends equal, a larger part than half is taken for the whole circle and a smaller part for the
/// ends. Nothing where a number is beyond the largest double.
std::optional<RoundedArc> arc_of_angles(const Point2& center, double radius, double start_degrees, double end_degrees);

/// Top of the arc over a chord, nearest doubles, with a bound for the distance; nothing beyond the largest double.
struct RoundedPoint {
  Point2 point;
  double distance = 0;
};
std::optional<RoundedPoint> top_of_arc(const Point2& a, const Point2& b, double bulge);

/// A radius for which bulge_of_radius comes as near as it can to the bulge, which is not zero, and how near; exact for
/// half circles.
struct RoundedRadius {
  double radius = 0;
  double distance = 0;
};
std::optional<RoundedRadius> radius_of_bulge(const Point2& a, const Point2& b, double bulge);

/// Bound of the distance between arcs of two bulges over one chord; 0 if they are equal.
double distance_of_bulges(const Point2& a, const Point2& b, double first, double second);

/// The circle over a diameter, if its centre and radius are doubles.
std::optional<DrawingCircle> circle_over_diameter(const Point2& a, const Point2& b);

}  // namespace quoin::io
