// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "quoin/arrangement/circular_family.h"

/// Input curves of a CircularFamily, cut at x-extremes. Every function appends the pieces of one curve to a list and
/// returns its id; where it throws InputError, naming `name`, list and curves are as before.
namespace quoin {

using CircularPieces = PieceList<CircularFamily>;

enum class ArcDirection : std::uint8_t { counterclockwise, clockwise };

/// Runs counterclockwise: lower half, then upper half.
CurveId add_circle(CircularFamily& family, CircularPieces& list, const Point2& centre, double radius,
                   std::string_view name = "circle");
CurveId add_circle(CircularFamily& family, CircularPieces& list, const RationalCircle& circle,
                   std::string_view name = "circle");

CurveId add_segment(CircularFamily& family, CircularPieces& list, const Point2& from, const Point2& to,
                    std::string_view name = "segment");
CurveId add_segment(CircularFamily& family, CircularPieces& list, const RationalPoint2& from, const RationalPoint2& to,
                    std::string_view name = "segment");

/// The arc of a circle between two different points, which must lie on it exactly.
CurveId add_arc(CircularFamily& family, CircularPieces& list, const Point2& centre, double radius, const Point2& from,
                const Point2& to, ArcDirection direction, std::string_view name = "arc");
CurveId add_arc(CircularFamily& family, CircularPieces& list, const RationalCircle& circle, const RationalPoint2& from,
                const RationalPoint2& to, ArcDirection direction, std::string_view name = "arc");
/// On a support that is there already.
CurveId add_arc(CircularFamily& family, CircularPieces& list, CircularSupportId circle, CircularPoint from,
                CircularPoint to, ArcDirection direction, std::string_view name = "arc");

/// The arc whose `bulge` is the tangent of a quarter of its angle, counterclockwise if positive: its circle is
/// rational. A segment if it is zero.
CurveId add_bulge_arc(CircularFamily& family, CircularPieces& list, const Point2& from, const Point2& to, double bulge,
                      std::string_view name = "arc");

CurveId add_point(CircularFamily& family, CircularPieces& list, const Point2& point, std::string_view name = "point");
CurveId add_point(CircularFamily& family, CircularPieces& list, const RationalPoint2& point,
                  std::string_view name = "point");

}  // namespace quoin
