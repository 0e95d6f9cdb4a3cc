// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/inputs.h"

#include <iostream>
#include <iterator>

#include "quoin/base/error.h"
#include "quoin/cli/diagnosis.h"
#include "quoin/io/exact_text.h"

namespace quoin::cli {

Mesh load_mesh(const std::string& name, const Options& options, std::vector<std::string>& warnings,
               const Context& context) {
  ReadOptions read;
  read.weld_tolerance = options.weld_tolerance;
  MeshFile file;
  if (name == "-") {
    const std::string bytes{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
    file = read_mesh(bytes, "standard input", read, context);
  } else {
    file = read_mesh(std::filesystem::path(name), read, context);
  }
  for (const std::string& w : file.report.warnings) warnings.push_back(name + ": " + w);
  return std::move(file.mesh);
}

namespace {

// The leaf, with the findings as warnings. @throws InputError with the findings where there is none
std::shared_ptr<const Leaf> accept(const std::string& name, const LeafResult& result,
                                   const std::vector<std::string>& findings, std::vector<std::string>& warnings) {
  if (!result.leaf) {
    std::string message = name + ": does not bound a solid";
    for (const std::string& line : findings) message += "\n  " + line;
    throw InputError(message);
  }
  for (const std::string& line : findings) warnings.push_back(name + ": " + line);
  if (result.leaf->tiles.empty()) warnings.push_back(name + ": " + no_faces);
  return result.leaf;
}

std::shared_ptr<const Leaf> leaf_of_boundary(const Brep& boundary, const std::string& name,
                                             std::vector<std::string>& warnings, const Context& context) {
  const LeafResult result = make_leaf(boundary, std::filesystem::path(name).stem().string(), {}, context);
  return accept(name, result, describe_boundary(result.diagnosis), warnings);
}

}  // namespace

std::shared_ptr<const Leaf> load_leaf(const std::string& name, const Options& options,
                                      std::vector<std::string>& warnings, const Context& context) {
  const LeafResult result = make_leaf(load_mesh(name, options, warnings, context), {}, context);
  return accept(name, result, describe(result.diagnosis), warnings);
}

bool is_exact_text(const std::string& name) {
  return std::filesystem::path(name).extension() == ".qsolid";
}

Solid load_operand(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                   const Context& context) {
  if (!is_exact_text(name)) return Solid::of_leaf(load_leaf(name, options, warnings, context));
  const Brep boundary = read_exact_text(read_file(name), name);
  std::shared_ptr<const Leaf> leaf = leaf_of_boundary(boundary, name, warnings, context);
  return boundary.is_unbounded ? Solid::of_complement(std::move(leaf)) : Solid::of_leaf(std::move(leaf));
}

std::shared_ptr<const Brep> load_boundary(const std::string& name, const Options& options,
                                          std::vector<std::string>& warnings, const Context& context) {
  if (!is_exact_text(name))
    return Solid::from_leaf(load_leaf(name, options, warnings, context), context).shared_boundary();
  auto boundary = std::make_shared<const Brep>(read_exact_text(read_file(name), name));
  leaf_of_boundary(*boundary, name, warnings, context);
  return boundary;
}

void print_warnings(const std::vector<std::string>& warnings, const Options& options) {
  if (options.quiet) return;
  for (const std::string& w : warnings) std::cerr << "quoin: warning: " << w << "\n";
}

}  // namespace quoin::cli
