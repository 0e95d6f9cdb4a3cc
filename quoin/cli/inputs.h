// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/cli/whole_input.h"
#include "quoin/io/mesh_file.h"
#include "quoin/solid/solid.h"

namespace quoin::cli {

/// What a file holds: a mesh or exact text.
using Input = std::variant<Mesh, Brep>;

/// Reads a file, or standard input for "-"; exact text is told by its ending or its first word. Warnings of the reader,
/// and what welding by a tolerance did, go to `warnings`.
Input read_input(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                 const Context& context);

/// The same from bytes in memory; `name` stands for the file.
Input input_of_bytes(const std::string& bytes, const std::string& name, const Options& options,
                     std::vector<std::string>& warnings, const Context& context);

/// An input as an operand, or why it is none.
LeafResult make_leaf(const Input& input, const std::string& name, const Context& context);

/// The solid of an input's leaf, evaluated; exact text may be of an unbounded one.
Solid solid_of_leaf(const Input& input, std::shared_ptr<const Leaf> leaf, const Context& context);

/// The solid that an input bounds, evaluated; the findings of its diagnosis go to `warnings`.
/// @throws InputError with the diagnosis when it does not bound a solid
Solid solid_of_input(const Input& input, const std::string& name, std::vector<std::string>& warnings,
                     const Context& context);

/// What a diagnosis of this input finds, a line each.
std::vector<std::string> describe(const Input& input, const MeshDiagnosis& diagnosis);

/// The message about an input that bounds no solid.
std::string refusal(const std::string& name, const std::string& verdict, const std::vector<std::string>& findings);

/// Reads an operand that is not evaluated. @throws InputError with the diagnosis when it does not bound a solid
Solid load_operand(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                   const Context& context);

/// Reads operands, with progress. @throws InputError as load_operand
std::vector<Solid> load_operands(const std::vector<std::string>& names, const Options& options,
                                 std::vector<std::string>& warnings, const Context& context);

/// Reads a boundary: exact text as it is, a mesh with its coplanar faces merged. @throws InputError as load_operand
std::shared_ptr<const Brep> load_boundary(const std::string& name, const Options& options,
                                          std::vector<std::string>& warnings, const Context& context);

std::string in_small_letters(std::string text);

/// The ending of a name with its dot, in small letters.
std::string ending_of(const std::string& name);

void print_warnings(const std::vector<std::string>& warnings, const Options& options);

}  // namespace quoin::cli
