// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/kernel/constructions.h"
#include "quoin/solid/leaf.h"

namespace quoin {

/// Tiles of a mesh and the faces they stem from.
struct MeshTiles {
  std::vector<Tile> tiles;
  std::vector<std::uint32_t> tile_face;
};

/// Cuts the faces of a mesh into triangles of nonzero area, exactly, and notes degenerate, skew and crossing faces.
/// `points` holds the vertices of the mesh. @throws InputError  a face names a vertex that is not there
MeshTiles make_tiles(const Mesh& mesh, const Constructions& points, std::size_t max_listed, MeshDiagnosis& diagnosis,
                     const Context& context);

/// Adds an element to a finding, listing no more than `max_listed`.
template <class Element>
void note(Finding<Element>& finding, const Element& element, std::size_t max_listed) {
  ++finding.count;
  if (finding.elements.size() < max_listed) finding.elements.push_back(element);
}

}  // namespace quoin
