// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "quoin/arrangement/arrangement.h"
#include "quoin/arrangement/location/location.h"

namespace quoin {

/// An x-monotone piece by its own end points; all belong to the family of the arrangement.
template <class Point>
struct ZonePiece {
  BranchId branch;
  Point left;
  Point right;
};

/// A maximal part of a piece inside one face, or along one edge.
template <class Point>
struct ZoneStep {
  Point left;
  Point right;
  Location at_left;   ///< a face only at the left end of the piece
  Location at_right;  ///< a face only at the right end of the piece; an end at infinity that no vertex is at counts so
  dcel::FaceId face;  ///< that the part runs through, or none if
  dcel::EdgeId overlapped;  ///< it runs along this edge
};

/// Follows a piece through an arrangement. It may change the arrangement behind the right end of the step.
template <class Point>
class ZoneVisitor {
 public:
  virtual ~ZoneVisitor() = default;
  /// From left to right. Returns the cell at the right end of the step, as it is after the visitor's changes; none to
  /// stop the walk.
  virtual std::optional<Location> at_step(const ZoneStep<Point>& step) = 0;
};

/// Finds the cell of a point that is not at infinity, as `locate` of a PointLocator does; none: by NaiveLocator.
template <class Point>
using ZoneLocator = std::function<Location(const Point&)>;

/// Walks along a piece, face by face, through everything that it meets: vertices, edges crossed or touched, edges that
/// it runs along. The left end is found by `locate`, or naively.
///
/// Exact. Linear in the complexity of the faces passed through, besides the location. On a plane.
/// @throws InputError on a surface with glued or contracted sides
template <CurveFamily F>
void zone(const Arrangement<F>& arrangement, const ZonePiece<typename F::Point>& piece,
          ZoneVisitor<typename F::Point>& visitor, const ZoneLocator<typename F::Point>& locate = {});

/// All steps of the walk; nothing is changed.
template <CurveFamily F>
std::vector<ZoneStep<typename F::Point>> zone_steps(const Arrangement<F>& arrangement,
                                                    const ZonePiece<typename F::Point>& piece,
                                                    const ZoneLocator<typename F::Point>& locate = {});

/// Whether a piece meets any vertex or edge, its ends included. Stops at the first.
template <CurveFamily F>
bool meets_anything(const Arrangement<F>& arrangement, const ZonePiece<typename F::Point>& piece,
                    const ZoneLocator<typename F::Point>& locate = {});

}  // namespace quoin
