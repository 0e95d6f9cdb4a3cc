// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/kernel/point.h"

/// The sphere as a rectangle of longitudes (x, from -180 to 180 degrees) and latitudes (y, from -90 to 90), for
/// drawing.
namespace quoin::longitude_chart {

inline constexpr double half_width = 180;
inline constexpr double half_height = 90;

/// A point of an arrangement, on the side of the rectangle where its copy is; a pole at the longitude of its meridian.
Point2 position(const GeodesicFamily::Point& p);

/// An edge from left to right, in steps of at most two degrees of longitude wherever doubles tell them apart. What lies
/// on the identification is on the left side.
std::vector<Point2> path(const GeodesicArrangement& arrangement, dcel::EdgeId edge);

}  // namespace quoin::longitude_chart
