// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/base/context.h"
#include "quoin/view/arrangement_picture.h"
#include "quoin/view/planar_picture.h"

namespace quoin {

/// The picture of an arrangement on the sphere in the plane: longitude to the right, latitude upward, in degrees
/// (longitude_chart.h). Every real cell, with what is known of it, in order; faces may be in several pieces.
///
/// The half meridian at -180 and 180 is both sides of the picture, and what lies on it is drawn twice; a vertex at a
/// pole is the whole upper or lower border. Faces come from an overlay with that half meridian. O(n log n).
/// @throws Cancelled
PlanarPicture flat_picture_of(const GeodesicArrangement& arrangement, const ArrangementPictureOptions& options,
                              const Context& context);

}  // namespace quoin
