// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/io/mesh_file.h"

namespace quoin {

/// An object of a file, as one mesh and as one for each of its groups.
struct MeshObject {
  std::string name;
  Mesh whole;
  std::vector<Mesh> groups;
};

/// What a file is made of: its objects, or where it has none, its groups as objects; nothing where it has neither.
/// Faces before the first of them are an object without a name, and groups of one name in an object are one. Meshes
/// have the vertices that they use, in the order of the file. O(size log size). @throws Cancelled
std::vector<MeshObject> objects_of(const MeshFile& file, const Context& context);

}  // namespace quoin
