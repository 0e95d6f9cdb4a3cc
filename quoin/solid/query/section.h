// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// The points x with normal . x = offset; the normal is not zero.
struct SectionPlane {
  RationalPoint3 normal;
  Rational offset;
};

/// A regular set in a plane: polygons with holes.
///
/// Loops have the set on their left seen from the tip of the normal: outer loops counterclockwise, holes clockwise. No
/// three successive points of a loop lie on a line; loops touch one another and themselves in points at most.
struct Section {
  std::vector<RationalPoint3> points;
  std::vector<std::vector<std::uint32_t>> loops;
  bool is_unbounded = false;  ///< contains all points of the plane far away
};

/// Cuts a solid by a plane.
///
/// The section is that of the solid just below the plane, on the side the normal points away from: what lies in the
/// plane is the boundary of the part below it. So a cube [0, 1]^3 has the unit square as its section by z = 1 and
/// nothing by z = 0, and sections by opposite normals differ only where faces lie in the plane. Exact. O(n) filtered
/// signs and O(k log k) rational operations for k edges cut. @throws InputError  the normal is zero
Section section(const Brep& boundary, const SectionPlane& plane, const Context& context);

/// Vector along the plane's normal whose length is the area of a bounded section; minus that of what is left out for an
/// unbounded one. Exact.
RationalPoint3 area_vector(const Section& section);

}  // namespace quoin
