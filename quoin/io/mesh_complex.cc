// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/mesh_complex.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "quoin/base/error.h"

namespace quoin {

namespace {

using Corners = std::vector<std::uint32_t>;

Corners corners_of(std::span<const std::uint32_t> face) {
  Corners corners(face.begin(), face.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  return corners;
}

// The same for all places to begin at and both ways around.
Corners canonical(const Corners& corners) {
  const std::size_t n = corners.size();
  if (n == 0) return {};
  const std::uint32_t smallest = *std::min_element(corners.begin(), corners.end());
  Corners least;
  for (std::size_t start = 0; start < n; ++start) {
    if (corners[start] != smallest) continue;
    for (const std::size_t step : {std::size_t{1}, n - 1}) {
      Corners turned(n);
      for (std::size_t i = 0; i < n; ++i) turned[i] = corners[(start + i * step) % n];
      if (least.empty() || turned < least) least = std::move(turned);
    }
  }
  return least;
}

class MeshFaces {
 public:
  explicit MeshFaces(std::size_t vertices) : next_vertex_(vertices) {}

  void add(const Corners& corners, SimplexList& list) {
    if (corners.size() <= 3) {  // neighbours, all of them, differ
      list.add(corners);
      return;
    }
    Corners sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    const bool has_repeated = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
    const Corners rim = has_repeated ? ring_along(corners, list) : corners;
    const std::uint32_t center = new_vertex();
    for (std::size_t i = 0; i < rim.size(); ++i) list.add(std::array{rim[i], rim[(i + 1) % rim.size()], center});
  }

 private:
  // New vertices, one beside each corner, with two triangles along each side.
  Corners ring_along(const Corners& corners, SimplexList& list) {
    Corners ring(corners.size());
    for (std::uint32_t& v : ring) v = new_vertex();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t j = (i + 1) % corners.size();
      list.add(std::array{corners[i], corners[j], ring[i]});
      list.add(std::array{ring[i], corners[j], ring[j]});
    }
    return ring;
  }

  std::uint32_t new_vertex() {
    if (next_vertex_ >= 0xFFFFFFFFU) throw InputError("the faces of the mesh need 2^32 vertices or more");
    return static_cast<std::uint32_t>(next_vertex_++);
  }

  std::size_t next_vertex_;
};

// Which faces have the corners of an earlier one.
std::vector<bool> repeated_faces(const std::vector<Corners>& canonical_corners) {
  std::vector<std::uint32_t> order(canonical_corners.size());
  for (std::uint32_t f = 0; f < order.size(); ++f) order[f] = f;
  std::sort(order.begin(), order.end(), [&](std::uint32_t f, std::uint32_t g) {
    return canonical_corners[f] != canonical_corners[g] ? canonical_corners[f] < canonical_corners[g] : f < g;
  });
  std::vector<bool> is_repeated(order.size(), false);
  for (std::size_t i = 1; i < order.size(); ++i)
    is_repeated[order[i]] = canonical_corners[order[i]] == canonical_corners[order[i - 1]];
  return is_repeated;
}

}  // namespace

MeshComplex complex_of_mesh(const Mesh& mesh, const Context& context) {
  MeshComplex result;
  std::vector<Corners> faces;
  std::vector<Corners> keys;
  std::vector<bool> is_corner(mesh.vertices.size(), false);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (f % 1024 == 0) context.poll();
    faces.push_back(corners_of(mesh.face(f)));
    keys.push_back(canonical(faces.back()));
    for (const std::uint32_t v : faces.back()) is_corner[v] = true;
  }
  result.lonely_vertices = static_cast<std::size_t>(std::count(is_corner.begin(), is_corner.end(), false));
  if (mesh.face_count() == 0)
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) result.simplices.add(std::array{v});
  const std::vector<bool> is_repeated = repeated_faces(keys);
  MeshFaces writer(mesh.vertices.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (f % 1024 == 0) context.poll();
    if (faces[f].size() < 3) ++result.thin_faces;
    if (is_repeated[f] && faces[f].size() > 2) ++result.repeated_faces;
    if (!is_repeated[f] && !faces[f].empty()) writer.add(faces[f], result.simplices);
  }
  return result;
}

}  // namespace quoin
