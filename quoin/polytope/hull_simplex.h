// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/constructions.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// As many affinely independent points as there are, up to four: the lexicographically smallest, the largest, one far
/// from their line and one far from their plane, each the first of equal ones. Exact. O(n).
struct Simplex {
  std::array<std::uint32_t, 4> points{};
  unsigned count = 0;
};
Simplex find_simplex(std::span<const Point3> points, const Context& context);
/// Of points of a table, by their rounded coordinates and their ids.
Simplex find_simplex(std::span<const Point3> rounded, const Constructions& table, std::span<const PointId> ids,
                     const Context& context);

/// The axis along which a plane projects without loss: the normal of the triangle is not perpendicular to it. The first
/// such axis.
unsigned axis_to_drop(const Point3& a, const Point3& b, const Point3& c);

/// Of some of the points, evenly chosen: those that reach furthest in 26 directions, roughly, without repetition,
/// ascending. O(1).
std::vector<std::uint32_t> extremes(std::span<const Point3> points, const Context& context);

}  // namespace quoin
