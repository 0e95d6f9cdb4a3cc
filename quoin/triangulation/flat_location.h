// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"
#include "quoin/triangulation/delaunay_walks.h"
#include "quoin/triangulation/triangulation_view3.h"

namespace quoin {

/// Finds points in a triangulation of dimension 0, 1 or 2: in the plane, on the line or at the point that its vertices
/// span. Exact. The triangulation must outlive it.
class FlatLocator {
 public:
  /// O(n); of dimension 0 and 1 8 bytes per vertex.
  explicit FlatLocator(const TriangulationView3& triangulation);

  /// Whether a finite point is in that plane, on that line, or there.
  bool spans(const Point3& p) const;

  /// Of dimension 2: the smallest face that a point of the plane is in, by a walk of at most so many steps from a cell,
  /// as it is seen along an axis: cells are before each other there as in their plane, so it ends without a limit, too.
  std::optional<DelaunayLocation> walk_in_plane(const Point3& p, std::uint32_t start, std::size_t steps) const;

  /// Of dimension 0 and 1: the smallest face that a finite point is in. O(log n).
  DelaunayLocation locate_on_line(const Point3& p) const;

  /// Of dimension 0 and 1: the vertices that are not hidden, in lexicographic order.
  std::span<const std::uint32_t> line() const { return line_; }

 private:
  void find_line();
  Point2 projected(const Point3& p) const { return {p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]}; }
  Point2 projected(std::uint32_t v) const { return projected(triangulation_.point(v)); }

  TriangulationView3 triangulation_;
  std::array<Point3, 3> basis_;  ///< what spans the plane, line or point: as many points as it takes
  unsigned axis_ = 0;            ///< along which a plane is seen
  Sign turn_ = Sign::zero;       ///< of all triangles, as they are seen
  std::vector<std::uint32_t> line_;
  std::vector<std::uint32_t> cells_;  ///< along the line, from ghost to ghost
};

}  // namespace quoin
