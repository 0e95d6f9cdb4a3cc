// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/kernel/constructions.h"

namespace quoin {

/// An axis along which the triangle of explicit points a, b, c projects to a triangle of nonzero area: of those, the
/// one with the largest area as far as doubles tell. Exact in that the area is not zero, also where doubles over- or
/// underflow.
/// @throws InternalError  the points lie on one line
unsigned projection_axis(const Constructions& points, PointId a, PointId b, PointId c);

}  // namespace quoin
