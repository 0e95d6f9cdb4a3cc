// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/mesh_objects.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace quoin {

namespace {

/// Faces of the file, in its order.
Mesh mesh_of(const Mesh& all, const std::vector<std::size_t>& faces, const std::string& name) {
  std::set<std::uint32_t> used;
  for (const std::size_t f : faces) used.insert(all.face(f).begin(), all.face(f).end());
  std::map<std::uint32_t, std::uint32_t> place;
  Mesh mesh;
  mesh.name = name;
  for (const std::uint32_t v : used) {
    place.emplace(v, static_cast<std::uint32_t>(mesh.vertices.size()));
    mesh.vertices.push_back(all.vertices[v]);
  }
  std::vector<std::uint32_t> corners;
  for (const std::size_t f : faces) {
    corners.clear();
    for (const std::uint32_t v : all.face(f)) corners.push_back(place.at(v));
    mesh.add_face(corners);
  }
  return mesh;
}

/// Numbers names in the order in which they come.
class Names {
 public:
  std::size_t number_of(const std::string& name) { return number_.try_emplace(name, number_.size()).first->second; }

 private:
  std::map<std::string, std::size_t> number_;
};

struct GatheredObject {
  std::string name;
  Names groups;
  std::vector<std::vector<std::size_t>> faces;  // by group
};

}  // namespace

std::vector<MeshObject> objects_of(const MeshFile& file, const Context& context) {
  const bool has_objects = std::ranges::any_of(file.groups, [](const MeshGroup& g) { return !g.object.empty(); });
  std::vector<GatheredObject> gathered;
  Names names;
  const auto add = [&](const MeshGroup& from, std::size_t begin, std::size_t end) {
    if (begin == end) return;
    const std::string& name = has_objects ? from.object : from.group;
    const std::size_t object = names.number_of(name);
    if (object == gathered.size()) gathered.push_back({name, {}, {}});
    GatheredObject& into = gathered[object];
    const std::size_t at = into.groups.number_of(has_objects ? from.group : std::string());
    if (at == into.faces.size()) into.faces.emplace_back();
    for (std::size_t f = begin; f < end; ++f) into.faces[at].push_back(f);
  };
  if (file.groups.empty()) return {};
  add({}, 0, file.groups[0].first_face);
  for (std::size_t g = 0; g < file.groups.size(); ++g) {
    if (g % 256 == 0) context.poll();
    const bool is_last = g + 1 == file.groups.size();
    add(file.groups[g], file.groups[g].first_face, is_last ? file.mesh.face_count() : file.groups[g + 1].first_face);
  }
  std::vector<MeshObject> objects;
  for (const GatheredObject& object : gathered) {
    context.poll();
    std::vector<std::size_t> all;
    for (const std::vector<std::size_t>& faces : object.faces) all.insert(all.end(), faces.begin(), faces.end());
    objects.push_back({object.name, mesh_of(file.mesh, all, object.name), {}});
    for (const std::vector<std::size_t>& faces : object.faces) {
      context.poll();
      objects.back().groups.push_back(mesh_of(file.mesh, faces, object.name));
    }
  }
  return objects;
}

}  // namespace quoin
