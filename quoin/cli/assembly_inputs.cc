// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/assembly_inputs.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>

#include "quoin/assembly/part_pieces.h"
#include "quoin/assembly/stopwatch.h"
#include "quoin/base/error.h"
#include "quoin/cli/diagnosis.h"
#include "quoin/cli/inputs.h"
#include "quoin/io/mesh_objects.h"
#include "quoin/solid/solid.h"

namespace quoin::cli {

namespace {

using Pieces = std::vector<Polytope>;

Pieces pieces_of(const Input& input, const std::string& what, std::vector<std::string>& warnings,
                 const Context& context) {
  return pieces_of_part(solid_of_input(input, what, warnings, context).boundary(), what, context);
}

/// A group that is a solid of its own, and what was found in it.
struct Body {
  Solid solid;
  std::vector<std::string> findings;
};

/// Nothing of a group that is open, bounds nothing or is inside out somewhere, as the wall of a cavity is.
std::optional<Body> body_of(const Mesh& group, const Context& context) {
  LeafResult made = quoin::make_leaf(group, {}, context);
  if (!made.leaf || made.diagnosis.inverted_components.count > 0) return std::nullopt;
  Solid solid = Solid::from_leaf(std::move(made.leaf), context);
  if (solid.is_empty()) return std::nullopt;
  return Body{std::move(solid), describe(made.diagnosis)};
}

/// Groups are pieces where each is a body; else, as those that only name faces, the surface of one body together.
Pieces pieces_of(const MeshObject& object, const std::string& what, std::vector<std::string>& warnings,
                 const Context& context) {
  std::vector<Body> bodies;
  for (const Mesh& group : object.groups) {
    std::optional<Body> body = body_of(group, context);
    if (!body) return pieces_of(object.whole, what, warnings, context);
    bodies.push_back(std::move(*body));
  }
  Pieces pieces;
  for (const Body& body : bodies) {
    for (const std::string& line : body.findings) warnings.emplace_back(what + ": ").append(line);
    std::ranges::move(pieces_of_part(body.solid.boundary(), what, context), std::back_inserter(pieces));
  }
  return pieces;
}

/// The objects of an OBJ or 3MF file that has some; nothing of any other input.
std::optional<std::vector<MeshObject>> read_objects(const std::string& name, const Options& options,
                                                    std::vector<std::string>& warnings, const Context& context) {
  if (ending_of(name) != ".obj" && ending_of(name) != ".3mf") return std::nullopt;
  ReadOptions read;
  read.weld_tolerance = options.weld_tolerance;
  const MeshFile file = read_mesh(std::filesystem::path(name), read, context);
  std::vector<MeshObject> objects = objects_of(file, context);
  if (objects.empty()) return std::nullopt;
  for (const std::string& warning : file.report.warnings) {
    const bool is_kept_here = warning.starts_with("'o' ") || warning.starts_with("'g' ");
    if (!is_kept_here) warnings.push_back(shown(name) + ": " + warning);
  }
  return objects;
}

std::string part_name(const std::string& file) {
  return file == standard_stream ? "standard input" : std::filesystem::path(file).stem().string();
}

/// The time that pieces take is that of their maps.
template <class MakePieces>
void add_part(const std::string& name, const MakePieces& make, std::vector<AssemblyPart>& parts,
              const Context& context) {
  Stopwatch watch;
  Pieces pieces = make();
  const double seconds = watch.lap();
  parts.push_back(make_part(name, std::move(pieces), context));
  parts.back().map_seconds = seconds;
}

void add_objects(const std::vector<MeshObject>& objects, const std::string& file, std::vector<AssemblyPart>& parts,
                 std::vector<std::string>& warnings, const Context& context) {
  for (const MeshObject& object : objects) {
    const std::string name = object.name.empty() ? part_name(file) : object.name;
    const std::string what = shown(file) + ": object '" + name + "'";
    add_part(
        name, [&] { return pieces_of(object, what, warnings, context); }, parts, context);
  }
}

void require_different_files(const std::vector<std::string>& files) {
  std::set<std::string> seen;
  for (const std::string& file : files) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::weakly_canonical(file, error);
    if (!seen.insert(error ? file : whole.string()).second)
      throw InputError(shown(file) + ": given twice, but parts cannot be in the same place");
  }
}

}  // namespace

std::vector<AssemblyPart> read_parts(const Options& options, std::vector<std::string>& warnings,
                                     const Context& context) {
  require_different_files(options.inputs);
  std::vector<AssemblyPart> parts;
  for (const std::string& file : options.inputs) {
    context.progress("parts", static_cast<double>(parts.size()) / static_cast<double>(options.inputs.size()));
    if (auto objects = read_objects(file, options, warnings, context)) {
      add_objects(*objects, file, parts, warnings, context);
      continue;
    }
    const Input input = read_input(file, options, warnings, context);
    add_part(
        part_name(file), [&] { return pieces_of(input, shown(file), warnings, context); }, parts, context);
  }
  return parts;
}

}  // namespace quoin::cli
