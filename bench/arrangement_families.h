// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "random.h"

/// The families of inputs of make_arrangement_inputs: integers, almost all of them within +-2^20.
namespace families {

using Int = std::int64_t;
using Segment = std::array<Int, 4>;   ///< x1 y1 x2 y2
using Circle = std::array<Int, 3>;    ///< cx cy r
using Normal = std::array<Int, 3>;    ///< of the plane of a great circle
using Geodesic = std::array<Int, 6>;  ///< ax ay az bx by bz
using Point = std::array<Int, 2>;     ///< x y
using Polygon = std::vector<Point>;   ///< simple, counterclockwise

// segment_families.cc
std::vector<Segment> long_segments(Int count, Random& random);
std::vector<Segment> short_segments(Int count, Random& random);
std::vector<Segment> perturbed_grid(Int cells, bool is_turned, Random& random);
std::vector<Segment> coverage(Int cells, Int noise, Random& random);
std::vector<Segment> lattice(Int count, Random& random);
std::vector<Segment> pencil(Int count, Random& random);
std::vector<Segment> band(Int count, Random& random);

// curve_families.cc
std::vector<Circle> circles(Int count, Random& random);
std::vector<Circle> discs(Int count, Random& random);
std::vector<Normal> great_circles(Int count, Random& random);
std::vector<Geodesic> geodesics(Int count, Random& random);

// polygon_families.cc
std::vector<Polygon> star_polygons(Int count, Random& random);
Polygon comb(Int vertices, bool is_turned, Random& random);
Polygon fork(Int vertices, bool is_fine);
std::vector<Point> queries(Int count, Random& random);

}  // namespace families
