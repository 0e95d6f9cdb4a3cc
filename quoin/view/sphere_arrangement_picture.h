// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "quoin/arrangement/arrangement.h"
#include "quoin/view/arrangement_picture.h"
#include "quoin/view/sphere_picture.h"

namespace quoin {

/// Where the cells of an arrangement on the sphere are.
struct SpherePlaces {
  std::vector<Vector3> vertices;            ///< unit vectors; anything where not real
  std::vector<std::vector<Vector3>> edges;  ///< from left to right, not more than 0.02 apart; empty where not real
};

/// Finds the face of each direction.
using LocateOnSphere = std::function<std::vector<dcel::FaceId>(const std::vector<Vector3>&)>;

/// The face on whose side of the nearest edge a direction lies, in doubles: right but for directions that are as close
/// to an edge as rounding. O(edges) each. The places must outlive it.
LocateOnSphere nearest_edge_locator(const dcel::Dcel& cells, const SpherePlaces& places);

/// What the cells say and look like, in the order of real cells, without a map of faces.
SpherePicture sphere_cells_of(const dcel::Dcel& cells, const CurveHistory& history, const SpherePlaces& places,
                              const ArrangementPictureOptions& options);

/// The picture of cells whose places are known; the map of faces is as wide as `map_width` pixels.
SpherePicture sphere_picture_of_cells(const dcel::Dcel& cells, const CurveHistory& history, const SpherePlaces& places,
                                      const ArrangementPictureOptions& options, const LocateOnSphere& locate,
                                      std::uint32_t map_width);

template <CurveFamily F>
SpherePlaces sphere_places_of(const Arrangement<F>& arrangement) {
  const dcel::Dcel& cells = arrangement.cells();
  SpherePlaces places;
  places.vertices.resize(cells.vertices.size());
  for (std::size_t i = 0; i < cells.vertices.size(); ++i) {
    const dcel::VertexId v(i);
    if (cells.is_real(v)) places.vertices[i] = arrangement.family().position(arrangement.point(v));
  }
  places.edges.resize(cells.edges.size());
  for (std::size_t i = 0; i < cells.edges.size(); ++i) {
    const dcel::EdgeId e(i);
    if (!cells.is_real(e)) continue;
    places.edges[i] = arrangement.family().flatten(arrangement.branch(e), arrangement.left_point(e),
                                                   arrangement.right_point(e), 0.02);
  }
  return places;
}

/// The picture of an arrangement on the sphere, whose family has `flatten`: every real cell, with what is known of it.
///
/// `locate` tells the faces of the map's pixels; without it they are found in doubles by the nearest edge.
template <CurveFamily F>
SpherePicture sphere_picture_of(const Arrangement<F>& arrangement, const ArrangementPictureOptions& options = {},
                                const LocateOnSphere& locate = {}, std::uint32_t map_width = 2048) {
  const SpherePlaces places = sphere_places_of(arrangement);
  return sphere_picture_of_cells(arrangement.cells(), arrangement.history(), places, options,
                                 locate ? locate : nearest_edge_locator(arrangement.cells(), places), map_width);
}

}  // namespace quoin
