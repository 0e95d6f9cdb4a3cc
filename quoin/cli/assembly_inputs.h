// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/assembly/part.h"
#include "quoin/base/context.h"
#include "quoin/cli/options.h"

namespace quoin::cli {

/// The parts of an assembly: a file each, named by its stem; or of OBJ and 3MF files with several objects, an object
/// each, whose groups are its pieces where each bounds a solid, none of them inside out. What is found wrong with a
/// surface goes to `warnings`.
/// @throws InputError  a file bounds no solid, is empty or unbounded, is not made of convex pieces, or is given twice
std::vector<AssemblyPart> read_parts(const Options& options, std::vector<std::string>& warnings,
                                     const Context& context);

}  // namespace quoin::cli
