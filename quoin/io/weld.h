// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/io/mesh_file.h"

namespace quoin::io {

/// Lets the first vertex of each set of equal ones stand for all, in order of first occurrence; -0 becomes +0. With a
/// tolerance, vertices within that distance of each other, and chains of such, become the first of them. O(n) expected.
void weld(Mesh& mesh, const ReadOptions& options, ReadReport& report, const Context& context);

}  // namespace quoin::io
