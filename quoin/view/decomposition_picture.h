// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/location/vertical_decomposition.h"
#include "quoin/view/arrangement_picture.h"

namespace quoin {

/// Puts the cells of a decomposition that have width in place of the faces of the picture of their arrangement, and
/// their walls, dashed, over its edges.
void show_decomposition(PlanarPicture& picture, const dcel::Dcel& cells, const CellPlaces& places,
                        const VerticalDecomposition& decomposition);

/// The picture of a vertical decomposition: its cells in the colours of their faces, with their walls dashed.
template <CurveFamily F>
PlanarPicture picture_of(const Arrangement<F>& arrangement, const VerticalDecomposition& decomposition,
                         const ArrangementPictureOptions& options = {}) {
  const CellPlaces places = places_of(arrangement, options);
  PlanarPicture picture = picture_of_cells(arrangement.cells(), arrangement.history(), places, options);
  show_decomposition(picture, arrangement.cells(), places, decomposition);
  return picture;
}

}  // namespace quoin
