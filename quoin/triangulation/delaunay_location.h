// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "quoin/triangulation/circulators.h"
#include "quoin/triangulation/delaunay_walks.h"
#include "quoin/triangulation/triangulation_view3.h"

namespace quoin {

/// Answers questions about points that need not be vertices, of a Delaunay or regular triangulation. Exact. The
/// triangulation must outlive it.
class DelaunayLocator {
 public:
  /// O(n), 4 bytes per vertex.
  explicit DelaunayLocator(const TriangulationView3& triangulation)
      : triangulation_(triangulation), stars_(triangulation) {}

  /// The smallest face that the point is in, by a walk from the cell of an earlier answer; it ends, since cells are in
  /// an acyclic order as seen from any point (Edelsbrunner 1990).
  /// @throws InputError if the point is not finite, or the dimension below 3
  DelaunayLocation locate(const Point3& p, std::uint32_t start = 0) const;

  /// The vertex of least distance, with weights of least power |p - v|^2 - weight, and so no hidden one; of equal ones
  /// the one of the smallest number; of any dimension. Walks over edges, each to a nearer vertex, from one sampled
  /// near.
  /// @throws InputError if the point is not finite
  std::uint32_t nearest(const Point3& p) const;

 private:
  int compare(const Point3& p, std::uint32_t v, std::uint32_t w) const;

  TriangulationView3 triangulation_;
  VertexStars stars_;
};

}  // namespace quoin
