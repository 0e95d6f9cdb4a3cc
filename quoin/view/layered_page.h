// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string_view>

#include "quoin/view/layered_scene.h"

namespace quoin {

/// Writes one self-contained HTML page that shows points and what stands on them: a slider goes through the values, a
/// persistence diagram goes with it. No network, no other file.
///
/// Every coordinate and value reaches the page as the double it is; drawing alone is in single precision, relative to
/// the centre and size of the points. Elements of a layer are written by the values from which on they are there, so
/// that the page draws the first of them, in one call; points of equal value in an order drawn with a fixed seed, so
/// that the first of them are a fair sample. Elements that are there at no value are left out. The same scene gives the
/// same bytes. O(size), with a copy of the layers.
/// @throws InputError  see check_layered_scene
/// @throws Error       the view was not built in (see has_view)
void write_layered_page(std::ostream& out, const LayeredScene& scene);

/// The same into a given template: HTML holding the markers of page_format.h once each.
void write_layered_page(std::ostream& out, const LayeredScene& scene, std::string_view page_template);

/// @throws InputError  a coordinate is not finite, values do not ascend or are no numbers, an index is out of range,
///                     lengths disagree, or a pair dies before it is born; says which. O(size).
void check_layered_scene(const LayeredScene& scene);

}  // namespace quoin
