// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"
#include "quoin/triangulation/weighted_point3.h"

namespace quoin {

/// The vertices of the regular triangulation of weighted points of a line, by their places, ascending: those that are
/// not above the lower hull of all, lifted by their square less their weight.
///
/// Points are given in lexicographic order, of equal ones the heaviest first: the others are above it. Exact, without
/// perturbation: points on the hull are vertices. O(n). Source: Andrew 1979. @throws Cancelled
std::vector<std::uint32_t> lower_chain(std::span<const Point3> points, std::span<const double> weights,
                                       const Context& context);

/// Of three points of a line, lifted by their squares less their weights: positive where the first is above the line
/// through the others, which differ in place. Exact.
Sign side_of_chord(const WeightedPoint3& p, const WeightedPoint3& a, const WeightedPoint3& b);

}  // namespace quoin
