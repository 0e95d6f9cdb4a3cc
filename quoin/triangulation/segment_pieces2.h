// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/constructions.h"
#include "quoin/kernel/point.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin {

/// A segment between two of a list of points, by their indices. Equal or coinciding ends make a point of it.
using Segment2 = std::array<std::uint32_t, 2>;

/// A given segment that runs along an edge, in its direction or against it.
struct SegmentUse2 {
  std::uint32_t segment;
  bool reversed;
  friend bool operator==(const SegmentUse2&, const SegmentUse2&) = default;
};

/// Points and segments cut where they meet: vertices are the distinct points and all crossings, pieces run between
/// vertices, no vertex lies inside a piece, and no two pieces cross.
struct SegmentPieces2 {
  struct Piece {
    Vertex2 source;  ///< the lexicographically smaller end
    Vertex2 target;
    std::uint32_t first_use;  ///< into `uses`, up to that of the next piece
  };

  /// Vertices are the ids: given points first, then crossings that are known to be doubles, then those known by the
  /// four ends of two segments; each kind along a curve. z is 0.
  Constructions table;
  std::vector<std::uint32_t> inputs;       ///< indices of points by vertex
  std::vector<std::uint32_t> input_begin;  ///< per given vertex and one more
  std::vector<Piece> pieces;
  std::vector<SegmentUse2> uses;

  std::span<const SegmentUse2> uses_of(std::size_t piece) const {
    const std::size_t end = piece + 1 < pieces.size() ? pieces[piece + 1].first_use : uses.size();
    return std::span(uses).subspan(pieces[piece].first_use, end - pieces[piece].first_use);
  }
};

/// Exact, by one sweep over all points and segments: O((n + k) log n) for k crossings.
/// @throws InputError  a point is not finite or a segment has an end that is no point; the first is named
/// @throws Cancelled
SegmentPieces2 cut_segments(std::span<const Point2> points, std::span<const Segment2> segments, const Context& context);

}  // namespace quoin
