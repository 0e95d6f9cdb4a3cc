// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/edit/cell_tracing.h"

#include <vector>

namespace quoin::dcel {

namespace {

void take_from_old_edges(const Dcel& before, const Dcel& after, CellMap& map, std::vector<FaceId>& known) {
  for (std::size_t i = 0; i < after.halfedges.size(); ++i) {
    const HalfedgeId h(i);
    const EdgeId old = map.old_edge[h.edge().index()];
    const FaceId face = after.face(h);
    if (old.is_none() || !map.old_face[face.index()].is_none()) continue;
    map.old_face[face.index()] = before.face(HalfedgeId(old, !h.is_forward()));
    known.push_back(face);
  }
}

}  // namespace

void trace_faces(const Dcel& before, const Dcel& after, CellMap& map) {
  map.old_face.assign(after.faces.size(), FaceId());
  map.new_face.assign(before.faces.size(), FaceId());
  std::vector<FaceId> known;
  take_from_old_edges(before, after, map, known);
  if (map.old_face[after.base_face.index()].is_none()) {
    map.old_face[after.base_face.index()] = before.base_face;
    known.push_back(after.base_face);
  }
  while (!known.empty()) {
    const FaceId face = known.back();
    known.pop_back();
    for (BoundaryId b = after[face].first_boundary; !b.is_none(); b = after[b].next) {
      const HalfedgeId start = after[b].halfedge;
      HalfedgeId h = start;
      do {
        const FaceId across = after.face(h.twin());
        if (map.old_edge[h.edge().index()].is_none() && after.is_real(h.edge()) &&
            map.old_face[across.index()].is_none()) {
          map.old_face[across.index()] = map.old_face[face.index()];
          known.push_back(across);
        }
        h = after.next(h);
      } while (h != start);
    }
  }
  for (std::size_t i = after.faces.size(); i-- > 0;) {
    if (!map.old_face[i].is_none()) map.new_face[map.old_face[i].index()] = FaceId(i);
  }
}

}  // namespace quoin::dcel
