// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/arrangement/sets/planar_rings.h"
#include "quoin/base/context.h"

namespace quoin::planar {

/// The convolution of the boundaries of two sets: for every edge of one and every vertex of the other whose turn
/// passes the edge's direction, the edge moved by the vertex. Taken with their signs, the edges are closed chains.
///
/// The winding number of these about t is the sum over all pairs of components P of A and Q of B of the Euler
/// characteristic of P and t - Q's intersection (Guibas, Ramshaw and Stolfi 1983; Schapira 1991). A hole that the other
/// component's bounding box cannot enter is filled first, which does not change the sum; after that no intersection has
/// a hole: it would be a hole of one operand within the other one, but its box is as large as the other one's. So the
/// number counts parts of the intersection, and is positive exactly inside the sum.
///
/// It is also right next to an edge: with the operands eroded a little, every edge moves to its left, so on the edge
/// itself the *open* sets meet in as many parts as on its right.
struct Convolution {
  struct Corner {
    std::uint32_t p;  ///< vertex of A, counted over all rings
    std::uint32_t q;  ///< vertex of B
  };
  struct Edge {
    std::uint32_t from;  ///< corner
    std::uint32_t to;
    std::uint32_t ring_of_a;  ///< counted over all rings
    std::uint32_t ring_of_b;
    bool is_backwards;  ///< to the lexicographically smaller end
    std::int8_t sign;   ///< negative where the vertex is reflex
  };

  /// The rings of an operand over a common list of points.
  struct Rings {
    std::vector<PlanarPoint> points;
    std::vector<std::uint32_t> next;  ///< by point
    std::vector<std::uint32_t> previous;
    std::vector<bool> is_hole;  ///< by ring
  };

  Rings a;
  Rings b;
  std::vector<Corner> corners;
  std::vector<Edge> edges;

  /// Whether the open sets meet close to the vertices p of A and q of t - B when these are at one place.
  bool meet_at(const Corner& corner) const;
};

/// O(n log n + k) for n vertices and k edges of the result. Directions that are equal count as if B were turned
/// counterclockwise by as little as no other order changes. @throws InputError if a set is unbounded; Cancelled
Convolution convolve(const LinearPolygonSet& a, const LinearPolygonSet& b, const Context& context);

}  // namespace quoin::planar
