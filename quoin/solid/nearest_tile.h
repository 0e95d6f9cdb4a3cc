// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "quoin/base/context.h"
#include "quoin/kernel/constructions.h"

namespace quoin {

/// The point of some triangle that is nearest to another point.
struct NearestPoint {
  Rational squared_distance{0};
  RationalPoint3 point{};
  std::uint32_t tile = 0;
};

enum class TouchingTiles : std::uint8_t { count, are_left_out };

/// Of triangles with an area over a table's points; nothing if there is none, or only such that hold the point and are
/// left out. Exact: triangles are measured in rationals, in order of the distance of their boxes until these are
/// further than the nearest found. O(n), and O(log n) for each that is measured.
std::optional<NearestPoint> nearest_point(const RationalPoint3& point, const Constructions& table,
                                          std::span<const std::array<PointId, 3>> tiles, TouchingTiles touching,
                                          const Context& context);

}  // namespace quoin
