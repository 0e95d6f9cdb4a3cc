// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "quoin/assembly/blocked_region.h"
#include "quoin/assembly/part.h"
#include "quoin/base/context.h"

namespace quoin {

/// Where the origin lies in the sums of pieces, counted for ordered pairs of parts: of the two sums of a pair of
/// pieces, which are reflections of one another, one is computed and both are counted.
struct SumCounts {
  std::size_t facet = 0;
  std::size_t edge = 0;
  std::size_t vertex = 0;
  std::size_t separated = 0;
  std::size_t total() const { return facet + edge + vertex + separated; }
};

/// Seconds of wall time by phase, numbered as in Table 5.2 of the source.
struct PhaseTimes {
  double maps = 0;          ///< 2: Gaussian maps of pieces
  double reflections = 0;   ///< 3
  double sums = 0;          ///< 4
  double projections = 0;   ///< 5
  double unions = 0;        ///< 6
  double motion_space = 0;  ///< 7
  double processing = 0;    ///< 8
  double total() const { return maps + reflections + sums + projections + unions + motion_space + processing; }
};

/// Two parts, first < second, and what the first meets when it moves and the second stays.
struct PartPair {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  std::vector<ConvexRegion> pieces;    ///< the first meets the second in their union
  std::vector<ConvexRegion> contacts;  ///< those of pieces that touch: what stops the smallest motion
  /// Of pairs of many pieces: what their boxes tell, outside of which nothing is blocked.
  std::optional<ConvexRegion> bounds;
};

/// All pairs of an assembly. Of (j, i) with i < j, everything is the reflection of (i, j).
struct PairRegions {
  std::size_t part_count = 0;
  std::vector<PartPair> pairs;  ///< in lexicographic order
  SumCounts counts;

  const PartPair& pair(std::uint32_t i, std::uint32_t j) const {
    return pairs[std::size_t{i} * (2 * part_count - i - 1) / 2 + (j - i - 1)];
  }
  /// Whether the part `moving` on its own would meet the other one on the way to infinity in this direction. Exact.
  bool is_blocked(std::uint32_t moving, std::uint32_t other, const RegionDirection& direction) const;
};

/// Two parts with common interior points.
struct OverlappingParts {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};

/// Sums and projections of all pairs of pieces of parts i < j: P_j + (-P_i) seen from the origin. Parts may touch.
///
/// Pieces whose boxes are apart, and in directions that others of the pair block already, need no sum; such pairs count
/// as separated. Pairs of parts run in parallel; the result does not depend on threads. Parts whose interiors meet are
/// listed in `overlaps`; what their regions hold means nothing. Source: Fogel 2009, section 5.3, phases 4 and 5;
/// antisymmetry as in 5.4.
/// @throws Cancelled
PairRegions project_pairs(std::span<const AssemblyPart> parts, std::vector<OverlappingParts>& overlaps,
                          PhaseTimes& times, const Context& context);

/// A region, and the arcs of blocking graphs that it stands for: (i, j) says that i moving into it meets j.
struct RegionGroup {
  BlockedRegion region;
  std::vector<std::array<std::uint32_t, 2>> arcs;
};

enum class MotionKind : std::uint8_t {
  infinite,      ///< a translation all the way
  infinitesimal  ///< the first step of one
};

/// Which ordered pairs count, by the part that moves and the one that stays; empty: all.
using PairFilter = std::function<bool(std::uint32_t, std::uint32_t)>;

/// The distinct regions of ordered pairs, each united once, reflected once, and listed with all pairs that have it. In
/// the order of the first pair. @throws Cancelled
std::vector<RegionGroup> unite_pairs(const PairRegions& pairs, MotionKind kind, PhaseTimes& times,
                                     const Context& context, const PairFilter& counts = {});

}  // namespace quoin
