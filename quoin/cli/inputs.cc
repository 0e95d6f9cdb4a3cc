// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/inputs.h"

#include <iostream>
#include <iterator>

#include "quoin/base/error.h"
#include "quoin/io/exact_text.h"

namespace quoin::cli {

namespace {

std::string name_of(std::uint32_t element) {
  return std::to_string(element);
}
std::string name_of(const MeshEdge& edge) {
  return std::to_string(edge.from) + "-" + std::to_string(edge.to);
}
std::string name_of(const FacePair& pair) {
  return std::to_string(pair.a) + "/" + std::to_string(pair.b);
}

template <class Element>
void describe(const Finding<Element>& finding, const std::string& what, std::vector<std::string>& lines) {
  if (finding.count == 0) return;
  std::string line = std::to_string(finding.count) + " " + what + ":";
  const std::size_t shown = std::min<std::size_t>(finding.elements.size(), 8);
  for (std::size_t i = 0; i < shown; ++i) line += " " + name_of(finding.elements[i]);
  if (finding.count > shown) line += " ...";
  lines.push_back(line);
}

void describe_surface(const MeshDiagnosis& d, std::vector<std::string>& lines) {
  describe(d.not_finite, "vertices are not finite", lines);
  describe(d.open_edges, "edges are open", lines);
  describe(d.misoriented_edges, "edges join faces of opposite orientation", lines);
  describe(d.crossing_faces, "pairs of faces cross or touch", lines);
  describe(d.inverted_components, "components are inside out (a face of each)", lines);
  describe(d.degenerate_faces, "faces are degenerate", lines);
  describe(d.duplicate_faces, "faces occur twice", lines);
  describe(d.nonmanifold_edges, "edges have more than two faces (legal)", lines);
}

}  // namespace

std::vector<std::string> describe(const MeshDiagnosis& d) {
  std::vector<std::string> lines;
  describe_surface(d, lines);
  describe(d.not_planar_faces, "faces are not planar and were triangulated", lines);
  describe(d.not_simple_faces, "faces cross themselves and were triangulated as fans", lines);
  return lines;
}

std::vector<std::string> describe_boundary(const MeshDiagnosis& d) {
  std::vector<std::string> lines;
  describe_surface(d, lines);
  describe(d.not_planar_faces, "faces have no plane or a vertex off it", lines);
  describe(d.not_simple_faces, "faces have loops that bound no polygon", lines);
  return lines;
}

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
