// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string_view>

#include "quoin/view/picture_colors.h"
#include "quoin/view/picture_frame.h"
#include "quoin/view/planar_picture.h"

/// Parts of an SVG drawing, for the file and for the page.
namespace quoin::svg_drawing {

/// Pixels to hundredths.
void write_pixel(std::ostream& out, double value);

/// Widths that suit how much there is to draw.
struct Strokes {
  double line = 1.4;  ///< width of plain edges
  double point = 3;   ///< radius
};
Strokes strokes_for(const PlanarPicture& picture, const PictureFrame& frame);

/// Style rules for one theme; each selector begins with `prefix`.
void write_theme_rules(std::ostream& out, const PlanarPicture& picture, PictureTheme theme, std::string_view prefix);
/// Style rules that hold for both.
void write_common_rules(std::ostream& out, const Strokes& strokes, std::string_view prefix);

/// Groups of class faces, edges and points, with one element for each cell, in order, even if it is not seen.
void write_cells(std::ostream& out, const PlanarPicture& picture, const PictureFrame& frame, bool has_tooltips);

}  // namespace quoin::svg_drawing
