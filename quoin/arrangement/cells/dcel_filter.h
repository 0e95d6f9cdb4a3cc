// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/arrangement/cells/dcel.h"

namespace quoin::dcel {

/// What to keep of a subdivision.
struct Filter {
  std::vector<bool> keep_edge;        ///< by edge; fictitious edges are always kept
  std::vector<bool> keep_vertex;      ///< by vertex: stays even if no kept edge is left at it
  std::vector<bool> dissolve_vertex;  ///< by vertex: its two kept edges, one to each side, become one
};

/// A subdivision with less in it, and where its cells come from.
struct Filtered {
  Dcel dcel;
  std::vector<VertexId> source_of_vertex;    ///< by new vertex
  std::vector<EdgeId> first_source_of_edge;  ///< by new edge: the leftmost old one
  std::vector<EdgeId> last_source_of_edge;   ///< by new edge: the rightmost old one
  std::vector<FaceId> face_of_source;        ///< by old face: the new face that holds it
};

/// Removes edges, joins faces across them, dissolves vertices; without any geometry.
///
/// The input is numbered canonically, and so is the result. Rings keep their order; faces are united across removed
/// edges, so no containment is computed. Linear but for the inverse of Ackermann's function.
Filtered filter(const Dcel& dcel, const Filter& what);

}  // namespace quoin::dcel
