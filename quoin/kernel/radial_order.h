// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/sign.h"
#include "quoin/kernel/constructions.h"
#include "quoin/kernel/point.h"

/// Order of half-planes about an edge by the angle from a reference, in [0, 360) degrees, counterclockwise seen from
/// the end of the edge towards its start; negative means that the first comes before the second.
///
/// Exact: signs of orientations and projected turns alone. For a fixed edge and reference it is a total preorder;
/// zero if and only if the half-planes are the same; the reference comes first. O(1).
namespace quoin {

/// The half-planes are bounded by the line from p to q and contain the points.
/// @throws InputError  a point lies on the line, or p = q
Sign compare_radially(const Point3& p, const Point3& q, const Point3& reference, const Point3& a, const Point3& b);

/// The same for any points of the table.
/// @throws InputError  a point lies on the line, or p and q are equal
Sign compare_radially(const Constructions& table, PointId p, PointId q, PointId reference, PointId a, PointId b);

/// The half-planes lie in planes that contain the line; each extends from it to the direction normal x line, so that
/// its normal is the reference's turned by the same angle.
Sign compare_radially(const Constructions& table, LineId line, PlaneId reference, PlaneId a, PlaneId b);

}  // namespace quoin
