// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/mesh.h"

namespace quoin {

/// What was done to some faces, by their indices in the mesh as it was given, ascending.
struct RepairChange {
  std::string what;
  std::vector<std::uint32_t> faces;
};

struct RepairResult {
  Mesh mesh;                               ///< over all vertices of the mesh as it was given
  std::vector<std::uint32_t> source_face;  ///< per face, its index in the mesh as it was given
  std::vector<RepairChange> changes;       ///< empty when nothing was changed
  std::vector<RepairChange> refusals;      ///< what could not be done, with the faces that stand in the way
};

/// Drops degenerate and superfluous faces, among them faces on a line that join no edges, and turns faces so that
/// neighbours agree and each shell bounds material from the right side.
///
/// Of faces with one outline, the excess of one direction over the other stays, once. Where directions balance, as in
/// walls between two shells, none stays unless the surface needs one to close: beside faces that end there, or where
/// the balanced faces are a surface of their own. Faces are turned by flood fill across edges with two faces, towards
/// what most faces of a connected component say; components that close only together, across edges of more faces, stay
/// together. A component that no orientation fits (a Klein bottle) is refused, and its faces stay as they are. What
/// lies inside an even number of others then faces outward, inward otherwise (exact ray counts); what does not close is
/// left alone. Self-crossings stay: the solid made from the mesh takes its points of positive winding number. O(n log
/// n) and one box test per pair of components.
/// @throws InputError  a face names a vertex that is not there
/// @throws Cancelled
RepairResult repair_mesh(const Mesh& mesh, const Context& context);

}  // namespace quoin
