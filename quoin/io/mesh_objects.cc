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

struct GatheredObject {
  std::string name;
  std::vector<std::string> groups;
  std::vector<std::vector<std::size_t>> faces;  // by group
};

template <class List, class Name>
std::size_t place_of(List& list, const std::string& name, const Name& name_of) {
  const auto at = std::ranges::find_if(list, [&](const auto& item) { return name_of(item) == name; });
  return static_cast<std::size_t>(at - list.begin());
}

}  // namespace

std::vector<MeshObject> objects_of(const MeshFile& file) {
  const bool has_objects = std::ranges::any_of(file.groups, [](const MeshGroup& g) { return !g.object.empty(); });
  std::vector<GatheredObject> gathered;
  const auto add = [&](const MeshGroup& from, std::size_t begin, std::size_t end) {
    if (begin == end) return;
    const std::string& name = has_objects ? from.object : from.group;
    const std::size_t object = place_of(gathered, name, [](const GatheredObject& o) { return o.name; });
    if (object == gathered.size()) gathered.push_back({name, {}, {}});
    GatheredObject& into = gathered[object];
    const std::string group = has_objects ? from.group : std::string();
    const std::size_t at = place_of(into.groups, group, [](const std::string& g) { return g; });
    if (at == into.groups.size()) {
      into.groups.push_back(group);
      into.faces.emplace_back();
    }
    for (std::size_t f = begin; f < end; ++f) into.faces[at].push_back(f);
  };
  if (file.groups.empty()) return {};
  add({}, 0, file.groups[0].first_face);
  for (std::size_t g = 0; g < file.groups.size(); ++g) {
    const bool is_last = g + 1 == file.groups.size();
    add(file.groups[g], file.groups[g].first_face, is_last ? file.mesh.face_count() : file.groups[g + 1].first_face);
  }
  std::vector<MeshObject> objects;
  for (const GatheredObject& object : gathered) {
    std::vector<std::size_t> all;
    for (const std::vector<std::size_t>& faces : object.faces) all.insert(all.end(), faces.begin(), faces.end());
    objects.push_back({object.name, mesh_of(file.mesh, all, object.name), {}});
    for (const std::vector<std::size_t>& faces : object.faces) {
      objects.back().groups.push_back(mesh_of(file.mesh, faces, object.name));
    }
  }
  return objects;
}

}  // namespace quoin
