// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/io/mesh_file.h"
#include "quoin/solid/solid.h"

namespace quoin::cli {

/// Reads a file or standard input and passes its warnings to `warnings`.
Mesh load_mesh(const std::string& name, const Options& options, std::vector<std::string>& warnings,
               const Context& context);

/// Reads a mesh as an operand. @throws InputError with the diagnosis when it does not bound a solid
std::shared_ptr<const Leaf> load_leaf(const std::string& name, const Options& options,
                                      std::vector<std::string>& warnings, const Context& context);

/// Whether a name ends in .qsolid.
bool is_exact_text(const std::string& name);

/// Exact text or a mesh as an operand that is not evaluated. @throws InputError as load_leaf
Solid load_operand(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                   const Context& context);

/// Exact text or a mesh as a boundary. @throws InputError as load_leaf
std::shared_ptr<const Brep> load_boundary(const std::string& name, const Options& options,
                                          std::vector<std::string>& warnings, const Context& context);

void print_warnings(const std::vector<std::string>& warnings, const Options& options);

}  // namespace quoin::cli
