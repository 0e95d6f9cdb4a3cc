// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "quoin/cli/proximity_inputs.h"
#include "quoin/polytope/proximity.h"

namespace quoin::cli {

/// What a moving solid casts on the floor, the plane of x and y: polygons that are filled where they wind about.
using Shadow = std::vector<std::vector<Point2>>;

/// Of convex pieces their outlines, of others the faces that look upward.
Shadow shadow_of(const ProximityOperand& operand, const Context& context);

/// A solid that moves along a path beside another, seen from above.
struct Trail {
  struct Step {
    Point2 at;
    Proximity relation;
  };
  struct Contact {
    Point2 from;
    Point2 to;
    Proximity relation;
  };
  Shadow moving;
  Shadow fixed;
  std::vector<Step> steps;
  std::vector<Contact> contacts;                 ///< parts of the way
  std::optional<std::array<Point2, 2>> nearest;  ///< points where they come nearest without contact
  std::string title;
};

/// Draws it as SVG, in colors by relation, light or dark as the reader prefers. At most 61 places are shown beside the
/// way itself. Rounded to hundredths of a pixel. @throws InputError  a coordinate is not finite
void draw_trail(std::ostream& out, const Trail& trail);

}  // namespace quoin::cli
