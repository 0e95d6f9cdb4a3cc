// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "quoin/triangulation/circulators.h"
#include "quoin/triangulation/delaunay_walks.h"
#include "quoin/triangulation/flat_location.h"
#include "quoin/triangulation/triangulation_view3.h"

namespace quoin {

/// Answers questions about points that need not be vertices, of a Delaunay or regular triangulation of any dimension.
/// Exact. The triangulation must outlive it.
class DelaunayLocator {
 public:
  /// O(n), 4 bytes per vertex; of dimension 0 and 1 12.
  explicit DelaunayLocator(const TriangulationView3& triangulation);

  /// The smallest face that the point is in, by a walk from the cell of an earlier answer, or, without it or where the
  /// walk from there takes more than `most_steps_from_hint` steps, from a vertex sampled near (Mücke, Saias and Zhu
  /// 1999); it ends, since cells are in an acyclic order as seen from any point (Edelsbrunner 1990). Of dimension 2 the
  /// same in the plane, in dimension 1 a search, O(log n); a point off the plane or line of all vertices is outside
  /// their affine hull.
  /// @throws InputError if the point is not finite
  DelaunayLocation locate(const Point3& p, std::uint32_t start = VertexStars::no_cell) const;

  /// The vertex of least distance, with weights of least power |p - v|^2 - weight, and so no hidden one; of equal ones
  /// the one of the smallest number; of any dimension, for points off the plane or line of all vertices, too. Walks
  /// over edges, each to a nearer vertex, from one sampled near; of dimension 1 O(log n) and the equal ones.
  /// @throws InputError if the point is not finite
  std::uint32_t nearest(const Point3& p) const;

 private:
  int compare(const Point3& p, std::uint32_t v, std::uint32_t w) const;
  std::uint32_t sampled_near(const Point3& p) const;
  std::uint32_t nearest_on_line(const Point3& p) const;

  TriangulationView3 triangulation_;
  VertexStars stars_;
  std::optional<FlatLocator> flat_;  ///< below dimension 3
};

}  // namespace quoin
