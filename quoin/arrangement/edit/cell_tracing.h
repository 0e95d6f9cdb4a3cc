// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/cells/dcel.h"
#include "quoin/arrangement/edit/observer.h"

namespace quoin::dcel {

/// Completes a map whose edges are known by its faces, where `after` refines `before`: faces of halfedges that lie on
/// old halfedges are known, the base face is the old one, and across new edges the old face is the same. Linear.
void trace_faces(const Dcel& before, const Dcel& after, CellMap& map);

}  // namespace quoin::dcel
