// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>

#include "quoin/view/planar_picture.h"

namespace quoin {

struct SvgOptions {
  double size = 900;  ///< longer side of the drawing in pixels
  bool has_points = true;
  bool has_edges = true;
  bool has_labels = true;    ///< those that the cells have, where there is room
  bool has_tooltips = true;  ///< names and facts, as titles of the elements
  bool has_legend = true;    ///< names of the picture's categories, if it has any
};

/// Draws a picture as one SVG file: y upward, light or dark as the reader prefers, arcs as arcs.
///
/// Positions are rounded to a hundredth of a pixel, arcs of more than 10,000 pixels become chords within 0.05 pixels.
/// Widths of lines suit how much there is to draw. The same picture gives the same bytes; no text of it can break out
/// of its element. The caller checks the stream for write errors.
/// @throws InputError  a coordinate is not finite, or the size is not positive
void write_svg(std::ostream& out, const PlanarPicture& picture, const SvgOptions& options = {});

}  // namespace quoin
