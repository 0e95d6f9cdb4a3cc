// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "quoin/assembly/assembly.h"
#include "quoin/cli/options.h"
#include "quoin/cli/targets.h"

namespace quoin::cli {

/// Writes the page of a plan: the sequence as a film, the sphere of directions with its cells, and who stops whom.
/// @throws FileError
void write_assembly_page(std::span<const AssemblyPart> parts, const AssemblyPlan& plan, const Target& target,
                         const Options& options, const Context& context);

}  // namespace quoin::cli
