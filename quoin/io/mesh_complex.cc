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

// Where to begin so that the rest is the least of all rotations. Of two candidates, the one that is larger after k
// equal corners is none, nor are the k next to it: O(n).
std::size_t start_of_least_rotation(const Corners& corners, const Context& context) {
  const std::size_t n = corners.size();
  const auto at = [&](std::size_t i) { return corners[i < n ? i : i - n]; };
  std::size_t one = 0;
  std::size_t two = 1;
  std::size_t equal = 0;
  for (std::size_t steps = 1; one < n && two < n && equal < n; ++steps) {
    if (steps % 4096 == 0) context.poll();
    if (at(one + equal) == at(two + equal)) {
      ++equal;
      continue;
    }
    (at(one + equal) > at(two + equal) ? one : two) += equal + 1;
    if (one == two) ++two;
    equal = 0;
  }
  return std::min(one, two);
}

// The same for all places to begin at and both ways around.
Corners canonical(const Corners& corners, const Context& context) {
  const auto least = [&](Corners turned) {
    const std::size_t start = start_of_least_rotation(turned, context);
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start), turned.end());
    return turned;
  };
  if (corners.empty()) return {};
  return std::min(least(corners), least({corners.rbegin(), corners.rend()}));
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
std::vector<bool> repeated_faces(const std::vector<Corners>& canonical_corners, const Context& context) {
  std::vector<std::uint32_t> order(canonical_corners.size());
  for (std::uint32_t f = 0; f < order.size(); ++f) order[f] = f;
  std::size_t compared = 0;
  std::sort(order.begin(), order.end(), [&](std::uint32_t f, std::uint32_t g) {
    if (++compared % 1024 == 0) context.poll();
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
    keys.push_back(canonical(faces.back(), context));
    for (const std::uint32_t v : faces.back()) is_corner[v] = true;
  }
  result.lonely_vertices = static_cast<std::size_t>(std::count(is_corner.begin(), is_corner.end(), false));
  if (mesh.face_count() == 0)
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) result.simplices.add(std::array{v});
  const std::vector<bool> is_repeated = repeated_faces(keys, context);
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
