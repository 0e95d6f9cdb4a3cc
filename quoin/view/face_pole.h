// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/view/picture_path.h"

namespace quoin {

/// Centre and radius of a disc inside a region; no disc: the radius is not positive.
struct Pole {
  Point2 at;
  double radius = 0;
};

/// The place of a region that is furthest from its boundary, to within `precision`: where a label has most room.
///
/// The region is what the polygons bound by the even-odd rule, cut to a box. Branch and bound over squares (after
/// Agafonkin's polylabel, 2016), at most a few hundred of them, each O(vertices).
Pole pole_of(const std::vector<std::vector<Point2>>& polygons, const PictureBox& box, double precision);

}  // namespace quoin
