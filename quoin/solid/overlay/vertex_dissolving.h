// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/solid/brep.h"

namespace quoin::overlay {

/// Drops every vertex at which, over the whole boundary, just two edges meet that lie on one line. Point ids are those
/// of `table`.
void dissolve_vertices(const Constructions& table, Brep& brep);

}  // namespace quoin::overlay
