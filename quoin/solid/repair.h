// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/mesh.h"

namespace quoin {

struct RepairResult {
  Mesh mesh;
  std::vector<std::string> changes;  ///< what was changed and how often; empty when nothing was
};

/// Drops degenerate and duplicate faces and turns faces so that neighbours agree and each shell bounds material from
/// the right side.
///
/// Faces are turned by flood fill across edges with two faces; a connected component faces outward when it lies inside
/// an even number of others, inward otherwise (exact ray counts). Self-crossings stay: the solid made from the mesh
/// takes its points of positive winding number. O(n log n). @throws Cancelled
RepairResult repair_mesh(const Mesh& mesh, const Context& context);

}  // namespace quoin
