// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/part_pieces.h"

#include "quoin/base/error.h"
#include "quoin/polytope/convex_pieces.h"
#include "quoin/polytope/decomposition.h"
#include "quoin/polytope/notches.h"
#include "quoin/solid/query/shell_components.h"

namespace quoin {

std::vector<Polytope> pieces_of_part(const Brep& boundary, const std::string& name, const Context& context) {
  if (boundary.is_unbounded) throw InputError(name + ": an unbounded solid is no part");
  if (boundary.face_count() == 0) throw InputError(name + ": the part is empty");
  std::vector<Polytope> pieces;
  for (Brep& component : component_boundaries(boundary, context)) {
    const bool is_convex = component.shells.size() == 1 && !has_notch(component, context);
    if (is_convex) {
      pieces.push_back(hull_of_boundary(component, context));
      continue;
    }
    const Solid solid = Solid::from_boundary(std::move(component), name, context);
    for (const Solid& piece : convex_decomposition(solid, context).pieces) {
      pieces.push_back(hull_of_boundary(piece.boundary(), context));
    }
  }
  return pieces;
}

}  // namespace quoin
