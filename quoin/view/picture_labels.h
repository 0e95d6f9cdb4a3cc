// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "quoin/view/picture_frame.h"
#include "quoin/view/planar_picture.h"

namespace quoin {

enum class CellKind : std::uint8_t { face, edge, point };

/// Where on the sheet the label of a cell belongs, in pixels.
struct LabelAnchor {
  CellKind kind = CellKind::face;
  std::size_t cell = 0;
  Point2 at;
  double room = 0;  ///< of a face: radius of a disc around it inside the face
  Point2 aside{};   ///< of an edge: unit vector away from it
};

/// Of all cells with a label that are seen on the sheet. O(size) for each labelled face.
std::vector<LabelAnchor> label_anchors(const PlanarPicture& picture, const PictureFrame& frame);

/// A label with its place; text is centred there.
struct PlacedLabel {
  LabelAnchor anchor;
  Point2 at;
  double size = 0;  ///< of the font
};

/// Places for labels such that none covers another or a point: faces in their middle, as large as there is room for,
/// points and edges beside them. What finds no room is left out.
std::vector<PlacedLabel> place_labels(const PlanarPicture& picture, const PictureFrame& frame);

/// Of one line of text in the fonts of the view, for a font of size 1; a little generous.
double text_width(std::string_view text);

}  // namespace quoin
