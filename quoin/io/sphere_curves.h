// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "quoin/arrangement/geodesic/geodesic_family.h"

namespace quoin {

/// Adds curves on the sphere from a text, one per line, comments from '#':
///
///   arc    ax ay az  bx by bz              the arc shorter than pi between two directions
///   arc    ax ay az  bx by bz  nx ny nz    the arc from a to b counterclockwise about the normal; ends may be
///   antipodal circle nx ny nz                        the great circle with that normal point  x y z
///
/// Directions are vectors of any length, three numbers each: decimals, which stand for the nearest doubles, or
/// fractions p/q, exact. Appends the names of the curves. O(size).
/// @throws InputError naming file and line: another word, missing numbers, a zero vector, ends that leave the plane of
/// an arc open
void read_sphere_curves(std::string_view text, const std::string& name, GeodesicFamily& family,
                        PieceList<GeodesicFamily>& list, std::vector<std::string>& names);

}  // namespace quoin
