// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string_view>

#include "quoin/view/plan_picture.h"

namespace quoin {

/// Writes one self-contained HTML page that shows how an assembly comes apart: the parts as they move, step by step,
/// the sphere of directions with its cells, and who stops whom in a cell that is picked. No network, no other file.
///
/// The same picture gives the same bytes.
/// @throws InputError  see check_plan
/// @throws Error       the view was not built in (see has_view)
void write_plan_page(std::ostream& out, const PlanPicture& picture);

/// The same into a given template: HTML holding the markers of page_format.h once each.
void write_plan_page(std::ostream& out, const PlanPicture& picture, std::string_view page_template);

/// @throws InputError  an index is out of range, a coordinate not finite, or a list of graphs does not fit its cells;
///                     says which. O(size).
void check_plan(const PlanPicture& picture);

}  // namespace quoin
