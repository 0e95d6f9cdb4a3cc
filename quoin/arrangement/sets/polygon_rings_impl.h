// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unordered_map>
#include <utility>

#include "quoin/arrangement/sets/polygon_set.h"
#include "quoin/base/error.h"

/// Body of `polygons_of`, for the one source file per family that instantiates it.
namespace quoin {

namespace polygon_rings_detail {

using dcel::HalfedgeId;

/// Runs counterclockwise: at its smallest vertex it leaves below where it arrived.
inline bool is_counterclockwise(const dcel::Dcel& cells, const std::vector<HalfedgeId>& cycle) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < cycle.size(); ++i) {
    if (cells.origin(cycle[i]) < cells.origin(cycle[least])) least = i;
  }
  return cycle[least] < cycle[(least + cycle.size() - 1) % cycle.size()].twin();
}

/// Starts every cycle at its smallest vertex.
inline void turn_to_smallest(const dcel::Dcel& cells, std::vector<HalfedgeId>& cycle) {
  const auto least = std::min_element(cycle.begin(), cycle.end(),
                                      [&](HalfedgeId a, HalfedgeId b) { return cells.origin(a) < cells.origin(b); });
  std::rotate(cycle.begin(), least, cycle.end());
}

/// Cuts a boundary where it comes back to a vertex; what it passes in both directions bounds nothing.
inline void cut_into_simple_cycles(const dcel::Dcel& cells, HalfedgeId first, std::vector<PolygonRing>& rings) {
  std::vector<HalfedgeId> path;
  std::unordered_map<dcel::VertexId, std::size_t> place;  // of vertices on the path
  HalfedgeId h = first;
  do {
    place[cells.origin(h)] = path.size();
    path.push_back(h);
    const auto seen = place.find(cells.target(h));
    if (seen != place.end()) {
      std::vector<HalfedgeId> cycle(path.begin() + static_cast<std::ptrdiff_t>(seen->second), path.end());
      path.resize(seen->second);
      for (const HalfedgeId gone : cycle) place.erase(cells.origin(gone));
      if (cycle.size() > 2 || cycle[0] != cycle.back().twin()) {
        const bool is_hole = !is_counterclockwise(cells, cycle);
        turn_to_smallest(cells, cycle);
        rings.push_back({std::move(cycle), is_hole});
      }
    }
    h = cells.next(h);
  } while (h != first);
}

}  // namespace polygon_rings_detail

template <CurveFamily F>
std::vector<PolygonWithHoles> polygons_of(const PolygonSet<F>& set) {
  if (set.is_unbounded()) throw InputError("an unbounded set has no outer boundary to write");
  const dcel::Dcel& cells = set.arrangement().cells();
  std::vector<PolygonWithHoles> polygons;
  for (std::size_t f = 0; f < cells.faces.size(); ++f) {
    if (!set.contains(dcel::FaceId(f))) continue;
    std::vector<PolygonRing> rings;
    for (dcel::BoundaryId b = cells.faces[f].first_boundary; !b.is_none(); b = cells[b].next) {
      polygon_rings_detail::cut_into_simple_cycles(cells, cells[b].halfedge, rings);
    }
    PolygonWithHoles polygon;
    for (PolygonRing& ring : rings) {
      if (ring.is_hole) {
        polygon.holes.push_back(std::move(ring));
      } else {
        polygon.outer = std::move(ring);
      }
    }
    const auto by_first = [&](const PolygonRing& a, const PolygonRing& b) { return a.halfedges[0] < b.halfedges[0]; };
    std::sort(polygon.holes.begin(), polygon.holes.end(), by_first);
    polygons.push_back(std::move(polygon));
  }
  std::sort(polygons.begin(), polygons.end(), [](const PolygonWithHoles& a, const PolygonWithHoles& b) {
    return a.outer.halfedges[0] < b.outer.halfedges[0];
  });
  return polygons;
}

}  // namespace quoin
