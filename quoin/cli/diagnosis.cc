// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/diagnosis.h"

#include <algorithm>
#include <utility>

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

std::string name_of(const std::vector<std::uint32_t>& band) {
  std::string name;
  for (const std::uint32_t face : band) name += (name.empty() ? "" : "-") + name_of(face);
  return name;
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

nlohmann::ordered_json json_of(std::uint32_t element) {
  return element;
}
nlohmann::ordered_json json_of(const MeshEdge& edge) {
  return {edge.from, edge.to};
}
nlohmann::ordered_json json_of(const FacePair& pair) {
  return {pair.a, pair.b};
}
nlohmann::ordered_json json_of(const std::vector<std::uint32_t>& band) {
  return band;
}

template <class Element>
void add(nlohmann::ordered_json& json, const char* key, const Finding<Element>& finding) {
  if (finding.count == 0) return;
  nlohmann::ordered_json elements = nlohmann::ordered_json::array();
  for (const Element& e : finding.elements) elements.push_back(json_of(e));
  json[key] = {{"count", finding.count}, {"elements", std::move(elements)}};
}

void rename(Finding<std::uint32_t>& finding, std::span<const std::uint32_t> name) {
  for (std::uint32_t& face : finding.elements) face = name[face];
}

void rename(Finding<FacePair>& finding, std::span<const std::uint32_t> name) {
  for (FacePair& pair : finding.elements) pair = {name[pair.a], name[pair.b]};
}

void rename(Finding<std::vector<std::uint32_t>>& finding, std::span<const std::uint32_t> name) {
  for (std::vector<std::uint32_t>& band : finding.elements) {
    for (std::uint32_t& face : band) face = name[face];
  }
}

void describe_surface(const MeshDiagnosis& d, std::vector<std::string>& lines) {
  describe(d.not_finite, "vertices are not finite", lines);
  describe(d.open_edges, "edges are open", lines);
  describe(d.misoriented_edges, "edges join faces of opposite orientation", lines);
  describe(d.one_sided_bands, "components fit no orientation (faces in a cycle that turns over, of each)", lines);
  describe(d.crossing_faces, "pairs of faces cross or touch", lines);
  describe(d.inverted_components, "components are inside out (a face of each)", lines);
  describe(d.degenerate_faces, "faces are degenerate", lines);
  describe(d.duplicate_faces, "faces occur twice", lines);
  describe(d.nonmanifold_edges, "edges have more than two faces (legal)", lines);
  describe(d.isolated_vertices, "vertices belong to no face", lines);
}

}  // namespace

std::vector<std::string> describe(const MeshDiagnosis& d) {
  std::vector<std::string> lines;
  describe_surface(d, lines);
  describe(d.not_planar_faces, "faces are not planar and were triangulated", lines);
  describe(d.not_simple_faces, "faces cross themselves and were triangulated as fans", lines);
  return lines;
}

std::string describe(const std::string& what, std::span<const std::uint32_t> elements) {
  std::vector<std::string> lines;
  describe(Finding<std::uint32_t>{elements.size(), {elements.begin(), elements.end()}}, what, lines);
  return lines.empty() ? "" : lines[0];
}

std::vector<std::string> describe_boundary(const MeshDiagnosis& d) {
  std::vector<std::string> lines;
  describe_surface(d, lines);
  describe(d.not_planar_faces, "faces have no plane or a vertex off it", lines);
  describe(d.not_simple_faces, "faces have loops that bound no polygon", lines);
  return lines;
}

nlohmann::ordered_json as_json(const MeshDiagnosis& d) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  add(json, "not_finite", d.not_finite);
  add(json, "open_edges", d.open_edges);
  add(json, "misoriented_edges", d.misoriented_edges);
  add(json, "one_sided_bands", d.one_sided_bands);
  add(json, "crossing_faces", d.crossing_faces);
  add(json, "inverted_components", d.inverted_components);
  add(json, "degenerate_faces", d.degenerate_faces);
  add(json, "duplicate_faces", d.duplicate_faces);
  add(json, "nonmanifold_edges", d.nonmanifold_edges);
  add(json, "isolated_vertices", d.isolated_vertices);
  add(json, "not_planar_faces", d.not_planar_faces);
  add(json, "not_simple_faces", d.not_simple_faces);
  return json;
}

void rename_faces(MeshDiagnosis& d, std::span<const std::uint32_t> name) {
  rename(d.one_sided_bands, name);
  rename(d.crossing_faces, name);
  rename(d.inverted_components, name);
  rename(d.degenerate_faces, name);
  rename(d.duplicate_faces, name);
  rename(d.not_planar_faces, name);
  rename(d.not_simple_faces, name);
}

}  // namespace quoin::cli
