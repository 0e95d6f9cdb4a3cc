// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>

#include "quoin/solid/query/section.h"

namespace quoin {

/// How far the drawing is from the section.
struct SvgReport {
  double largest_rounding = 0;  ///< no coordinate of the drawing is further from its exact place, in the solid's units
};

/// Draws a section as one filled path in millimetres for one unit each, seen from the tip of the plane's normal.
///
/// The drawing's x axis points along the projection of the coordinate axis x (y where the normal is mostly along x).
/// Coordinates are doubles in shortest decimals. @throws InputError  the section is unbounded
SvgReport write_svg(std::ostream& out, const Section& section, const SectionPlane& plane);

}  // namespace quoin
