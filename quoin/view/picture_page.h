// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string_view>

#include "quoin/view/planar_picture.h"

namespace quoin {

/// Writes one self-contained HTML page to look into a picture: pan and zoom, what is under the pointer lights up and
/// says what it is, points, edges and labels come and go. Keys do all of it. No network, no other file.
///
/// The drawing is that of write_svg, and reaches one more sheet to every side. The same picture gives the same bytes.
/// @throws InputError  as write_svg
/// @throws Error       the view was not built in (see has_view)
void write_picture_page(std::ostream& out, const PlanarPicture& picture);

/// The same into a given template: HTML holding the markers of page_format.h once each.
void write_picture_page(std::ostream& out, const PlanarPicture& picture, std::string_view page_template);

}  // namespace quoin
