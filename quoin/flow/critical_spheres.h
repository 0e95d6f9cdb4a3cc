// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "quoin/flow/flow_cells.h"
#include "quoin/triangulation/smallest_spheres.h"

namespace quoin {

/// The vertices of a face that has a critical point.
struct CriticalFace {
  std::array<std::uint32_t, 4> vertices{};
  std::size_t size = 0;

  static CriticalFace edge(const FlowCells& flow, std::uint32_t cell, unsigned edge);
  static CriticalFace facet(const FlowCells& flow, CellFacet facet);
  static CriticalFace simplex(const FlowCells& flow, std::uint32_t cell);
};

/// Squared distances at critical points for who sorts millions of them: squared radii of the smallest spheres through
/// their faces, in integers as wide as these points need. What CriticalValues knows as rationals.
class CriticalSpheres {
 public:
  /// O(n), 24 bytes per vertex.
  explicit CriticalSpheres(std::vector<Point3> points) : spheres_(std::move(points)) {}
  explicit CriticalSpheres(const Delaunay3& triangulation);

  /// Of a width of a few units in the last place.
  Interval close_square(const CriticalFace& face) const { return spheres_.close_power(simplex(face)); }
  ExactQuotient exact_square(const CriticalFace& face) const { return spheres_.exact_power(simplex(face)); }

 private:
  static SmallestSpheres::Simplex simplex(const CriticalFace& face) { return {face.vertices.data(), face.size}; }

  SmallestSpheres spheres_;
};

}  // namespace quoin
