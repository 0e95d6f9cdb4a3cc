// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include "quoin/base/context.h"
#include "quoin/io/exact_cells.h"

namespace quoin {

/// Writes cells exactly: every coordinate and number as the double that it is, or as a rational. Text, lines, described
/// in docs/exact-text.md. O(size). @throws Cancelled
void write_cells_text(std::ostream& out, const ExactCells& cells, const Context& context);

/// Reads them back without loss; written again they are the same, byte for byte. A simplex or polygon has each point
/// once. A polyhedron is a closed surface of one piece without handles, with its faces turned outward, and no two lie
/// on the same side of a face. O(n log n).
/// @throws InputError with file and line; Cancelled
ExactCells read_cells_text(std::string_view text, const std::string& name, const Context& context);

/// Whether a text begins like one of these, behind comments.
bool is_cells_text(std::string_view text);

}  // namespace quoin
