// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/solid/query/point_location.h"

namespace quoin {

/// The points origin + t direction for all rational t; the direction is not zero.
struct Line3 {
  RationalPoint3 origin;
  RationalPoint3 direction;
};

/// A point in which a line enters, leaves or touches the boundary, or changes from one face or edge to another.
struct LineEvent {
  Rational parameter;
  RationalPoint3 point;
  SolidLocation location;
};

/// A line cut by a boundary: piece i lies before event i, the last piece behind the last event.
struct LineClassification {
  std::vector<LineEvent> events;      ///< by ascending parameter
  std::vector<SolidLocation> pieces;  ///< events.size() + 1 of them; in, out, on a face or along an edge
};

/// Cuts a line by the boundary. Exact. O(log n + c) for c corners of faces near the line, times O(log n) per event.
/// @throws InputError  the direction is zero
LineClassification classify_line(const SolidLocator& locator, const Line3& line, const Context& context);

}  // namespace quoin
