// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "quoin/arrangement/circular/circular_envelope.h"
#include "quoin/arrangement/linear/linear_envelope.h"
#include "quoin/io/drawing.h"

namespace quoin {

/// The point of a branch over the x of a point. Of lines both coordinates are the nearest doubles; of circles x is
/// within the family's error, and y goes with it.
Point2 point_over(const LinearFamily& family, BranchId branch, const LinearPoint& x);
Point2 point_over(const CircularFamily& family, BranchId branch, const CircularPoint& x);

/// Where the curve of an interval begins and ends over it; nothing at infinity and for gaps.
template <class F>
std::optional<Point2> left_end(const F& family, const Envelope<F>& envelope, std::size_t interval) {
  if (interval == 0 || envelope.is_gap(interval)) return std::nullopt;
  return point_over(family, envelope.branch(interval), envelope.point(interval - 1));
}
template <class F>
std::optional<Point2> right_end(const F& family, const Envelope<F>& envelope, std::size_t interval) {
  if (interval == envelope.breakpoint_count() || envelope.is_gap(interval)) return std::nullopt;
  return point_over(family, envelope.branch(interval), envelope.point(interval));
}

/// An envelope as paths from left to right, as long as it is continuous, and points by which it drops for one x only.
/// Vertices are rounded, arcs become bulges; a note says how many intervals are too short for doubles.
/// @throws InputError  the envelope reaches infinity
Drawing draw_envelope(const LinearFamily& family, const LinearEnvelope& envelope);
Drawing draw_envelope(const CircularFamily& family, const CircularEnvelope& envelope);

}  // namespace quoin
