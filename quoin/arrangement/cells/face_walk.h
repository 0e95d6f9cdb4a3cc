// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/arrangement/cells/dcel.h"

namespace quoin::dcel {

/// Visits every real face once, from the base face on, along a tree of the dual graph.
///
/// `cross(h)` is called for every step from the face of h to the face of its twin, also for the steps back, so that a
/// caller can keep one label up to date instead of storing one per face; then `visit(face)` at the first arrival.
/// O(size) calls.
template <class Cross, class Visit>
void walk_faces(const Dcel& dcel, const Cross& cross, const Visit& visit) {
  struct Place {
    HalfedgeId entry;  // in this face, the one it was entered over; none at the start
    BoundaryId boundary;
    HalfedgeId at;  // next halfedge to look across; none: the boundary's first
  };
  std::vector<bool> is_visited(dcel.faces.size(), false);
  std::vector<Place> path;
  const auto enter = [&](FaceId face, HalfedgeId entry) {
    is_visited[face.index()] = true;
    visit(face);
    path.push_back({entry, dcel[face].first_boundary, HalfedgeId()});
  };
  enter(dcel.base_face, HalfedgeId());
  while (!path.empty()) {
    Place& place = path.back();
    if (place.boundary.is_none()) {
      if (!place.entry.is_none()) cross(place.entry);
      path.pop_back();
      continue;
    }
    const HalfedgeId first = dcel[place.boundary].halfedge;
    const HalfedgeId h = place.at.is_none() ? first : place.at;
    place.at = dcel.next(h);
    if (place.at == first) {
      place.boundary = dcel[place.boundary].next;
      place.at = HalfedgeId();
    }
    if (!dcel.is_real(h.edge())) continue;
    const FaceId other = dcel.face(h.twin());
    if (is_visited[other.index()]) continue;
    cross(h);
    enter(other, h.twin());
  }
}

}  // namespace quoin::dcel
