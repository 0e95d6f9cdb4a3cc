// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string_view>

#include "quoin/view/scene.h"

namespace quoin {

/// Whether the browser view was built into this library (QUOIN_VIEW).
bool has_view();

/// Writes one self-contained HTML page that shows the scene in a browser: no network, no other file.
///
/// The page draws in single precision relative to the scene's centre and keeps every coordinate as the double it is,
/// for measuring. Streams: beyond the scene itself it holds a few kilobytes. The same scene gives the same bytes. An
/// empty scene gives a page that says so. The caller checks the stream for write errors.
/// @throws InputError  a coordinate or plane is not finite, an index is out of range, or array lengths disagree; names
///                     the part and the element
/// @throws Error       the view was not built in
void write_page(std::ostream& out, const ViewScene& scene);

/// The same into a given template: HTML holding the markers of page_format.h once each.
void write_page(std::ostream& out, const ViewScene& scene, std::string_view page_template);

}  // namespace quoin
