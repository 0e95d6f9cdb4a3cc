// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string_view>

#include "quoin/view/sphere_picture.h"

namespace quoin {

/// Writes one self-contained HTML page that shows a sphere with its faces, edges and points in a browser: it turns, by
/// itself if wished, and what is under the pointer lights up and says what it is. No network, no other file.
///
/// The same picture gives the same bytes.
/// @throws InputError  see check_picture
/// @throws Error       the view was not built in (see has_view)
void write_sphere_page(std::ostream& out, const SpherePicture& picture);

/// The same into a given template: HTML holding the markers of page_format.h once each.
void write_sphere_page(std::ostream& out, const SpherePicture& picture, std::string_view page_template);

/// What of a page tells the picture, for pages that show more than a sphere. The picture was checked.
void write_sphere_blocks(std::ostream& out, const SpherePicture& picture);

}  // namespace quoin
