// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "quoin/solid/brep.h"

namespace quoin {

/// Elements of a boundary, and where it is no manifold.
struct TopologyCounts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t loops = 0;
  std::size_t unbalanced_edges = 0;   ///< not used as often in one direction as in the other: never in a valid boundary
  std::size_t nonmanifold_edges = 0;  ///< with more than two faces
  std::size_t nonmanifold_vertices = 0;  ///< whose faces form more than one fan, or that touch a face

  bool is_closed() const { return unbalanced_edges == 0; }
  bool is_manifold() const { return is_closed() && nonmanifold_edges == 0 && nonmanifold_vertices == 0; }
};

/// O(n log n), from the loops alone.
TopologyCounts count_topology(const Brep& boundary);

/// What of a boundary does not depend on coordinates, nor on how its surface is cut into faces.
struct Topology {
  std::size_t components = 0;
  std::size_t shells = 0;
  std::size_t voids = 0;
  bool is_manifold = true;
  std::size_t handles = 0;  ///< of all shells together; 0 where the boundary is no manifold
  friend bool operator==(const Topology&, const Topology&) = default;

  /// Equal but for touching itself: as many components, shells and voids, and handles where both are manifolds.
  bool has_parts_of(const Topology& other) const {
    return components == other.components && shells == other.shells && voids == other.voids &&
           (!is_manifold || !other.is_manifold || handles == other.handles);
  }
};

/// O(n log n). Handles by Euler and Poincare: V - E + F - (L - F) = 2 (shells - handles).
Topology topology_of(const Brep& boundary);

}  // namespace quoin
