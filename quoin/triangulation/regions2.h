// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/triangulation/constrained2.h"

namespace quoin {

/// What the segments of a constrained triangulation divide the plane into, as far as triangles tell: a region is a
/// largest set of triangles joined across edges that are no pieces of segments. Region 0 is the unbounded one; the part
/// of it in the convex hull has finite triangles.
///
/// For closed chains of segments, a region is inside by parity or by winding number, holes and islands included; a hole
/// may also be named by a point in it (`find_triangle`). Chains that end somewhere bound nothing there, and are edges
/// inside of a region.
class Regions2 {
 public:
  /// O(n).
  explicit Regions2(const ConstrainedDelaunay2& triangulation);

  std::size_t count() const { return depth_.size(); }
  std::uint32_t region(Triangle2 t) const { return region_[t.index()]; }
  /// Of all triangles.
  std::span<const std::uint32_t> regions() const { return region_; }
  /// The least number of pieces that a path from the unbounded region crosses: odd inside of nested simple polygons.
  std::uint32_t depth(std::uint32_t region) const { return depth_[region]; }
  /// Whether all paths agree about how often segments are crossed from right to left: so for closed chains, each
  /// segment of which runs in the direction of its chain.
  bool has_windings() const { return has_windings_; }
  /// How often the chains of segments run counterclockwise about the region; without meaning unless has_windings().
  std::int64_t winding(std::uint32_t region) const { return winding_[region]; }

 private:
  std::vector<std::uint32_t> region_;
  std::vector<std::uint32_t> depth_;
  std::vector<std::int64_t> winding_;
  bool has_windings_ = true;
};

}  // namespace quoin
