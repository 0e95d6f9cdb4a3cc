// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/flow_points.h"

namespace quoin {

/// What happens at a stationary point that is not critical.
enum class AtRegularPoint {
  stop,  ///< the orbit ends, as the flow itself does
  /// It goes on along a Voronoi edge, away from the hull of the nearest points: the level sets do not change there. If
  /// there are several such edges, along that of the polygon with the lowest number.
  pass
};

/// A part of an orbit in one open Voronoi face. Faces are named by their duals.
struct FlowSegment {
  DeloneFace start;    ///< that has the first point
  DeloneFace crossed;  ///< that the segment goes through
  /// That has the last point; nothing at infinity.
  std::optional<DeloneFace> reached;
};

/// One step of the flow from a point.
struct FlowStep {
  bool stops = false;   ///< the point is stationary, and there is no segment
  bool passes = false;  ///< the point is stationary and the step goes on nevertheless
  FlowSegment segment;
  std::uint32_t point = FlowPoints::none;  ///< the last one; none at infinity
};

/// O(k) for a point whose face has k faces around it.
FlowStep flow_step(FlowPoints& points, std::uint32_t point, AtRegularPoint at_regular = AtRegularPoint::stop);

/// The way of a point.
struct FlowOrbit {
  FlowPoints points;                  ///< in order; the start first
  std::vector<FlowSegment> segments;  ///< between consecutive ones; the last one may end at infinity
  bool is_infinite = false;
  bool has_passed_regular = false;
  /// The face whose dual has the last point.
  DeloneFace end{};
};

/// The orbit of any point, for example one of doubles, until it stops. Exact. Distances grow along an orbit, so it
/// ends.
/// @throws Cancelled
FlowOrbit flow_orbit(const FlowComplex& flow, const RationalPoint3& start, const Context& context,
                     AtRegularPoint at_regular = AtRegularPoint::stop);

}  // namespace quoin
