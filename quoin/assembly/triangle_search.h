// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/assembly/pair_regions.h"
#include "quoin/base/context.h"

namespace quoin {

/// A closed triangle of directions, its corners counterclockwise and less than half a circle apart.
struct DirectionTriangle {
  explicit DirectionTriangle(const std::array<RegionDirection, 3>& corners);

  std::array<RegionDirection, 3> corners;
  std::array<RegionDirection, 3> inward;  ///< normals of its sides

  /// Exact.
  bool contains(const RegionDirection& direction) const;
};

/// How an ordered pair of parts is over a set of directions.
enum class PairState : std::uint8_t { never_blocked, always_blocked, mixed };

/// What is left of the sphere when all is left out where nothing can move.
struct UnsettledDirections {
  std::vector<DirectionTriangle> triangles;
  std::vector<PairState> states;  ///< over all triangles; of i moving and j staying at i * parts + j

  bool contain(const RegionDirection& direction) const;
};

/// Branch and bound over triangles: the octants, then quarters of triangles. In a triangle, a pair is surely blocked if
/// the triangle is inside one of its regions, and surely not if it misses all of them. Where the surely blocked pairs
/// alone hold all parts together, no direction of the triangle is a solution, for further arcs only hold them more: the
/// triangle is settled. Others are divided until none has mixed pairs, or `most_triangles` were looked at.
///
/// Every solution of any cell is inside of what is left, never on its border. Exact. O(triangles * pieces of pairs).
/// @throws Cancelled
UnsettledDirections find_unsettled(const PairRegions& pairs, std::size_t most_triangles, const Context& context);

}  // namespace quoin
