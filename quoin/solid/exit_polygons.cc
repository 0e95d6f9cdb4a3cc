// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/exit_polygons.h"

#include <algorithm>
#include <vector>

#include "quoin/kernel/predicates3.h"

namespace quoin {

namespace {

bool has_repetition(std::span<const PointId> loop, std::vector<std::uint32_t>& sorted) {
  sorted.clear();
  for (const PointId p : loop) sorted.push_back(p.value);
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

// `triangle` spans the plane: it has an area. What did not move is where its plane is.
bool is_planar(std::span<const PointId> loop, const Tile& triangle, std::span<const Point3> positions,
               std::span<const std::uint8_t> moved) {
  if (std::none_of(loop.begin(), loop.end(), [&](PointId p) { return moved[p.value] != 0; })) return true;
  return std::all_of(loop.begin(), loop.end(), [&](PointId p) {
    return orientation(positions[triangle[0]], positions[triangle[1]], positions[triangle[2]], positions[p.value]) ==
           Sign::zero;
  });
}

}  // namespace

FacePolygons find_polygons(const Brep& boundary, std::span<const Point3> positions, std::span<const std::uint8_t> moved,
                           std::span<const Tile> triangles, std::span<const std::uint32_t> triangle_face,
                           const Context& context) {
  FacePolygons result;
  std::vector<std::uint32_t> sorted;
  for (std::uint32_t begin = 0, end = 0; begin < triangles.size(); begin = end) {
    const std::uint32_t face = triangle_face[begin];
    while (end < triangles.size() && triangle_face[end] == face) ++end;
    if (end - begin < 2 || boundary.face_first_loop[face + 1] - boundary.face_first_loop[face] != 1) continue;
    if (face % 256 == 0) context.poll();
    const auto loop = boundary.loop(boundary.face_first_loop[face]);
    if (loop.size() != end - begin + 2 || has_repetition(loop, sorted)) continue;
    if (!is_planar(loop, triangles[begin], positions, moved)) continue;
    for (const PointId p : loop) result.corners.push_back(p.value);
    result.begin.push_back(static_cast<std::uint32_t>(result.corners.size()));
    result.first_triangle.push_back(begin);
  }
  return result;
}

}  // namespace quoin
