// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/convex_pieces.h"

#include <algorithm>

#include "quoin/polytope/notches.h"

namespace quoin {

std::optional<std::vector<Polytope>> convex_pieces(const Brep& boundary, const Context& context) {
  const bool has_voids = std::ranges::any_of(boundary.shells, &Shell::is_void);
  if (boundary.is_unbounded || has_voids || has_notch(boundary, context)) return std::nullopt;
  std::vector<std::vector<PointId>> corners(boundary.shells.size());
  for (std::uint32_t f = 0; f < boundary.face_count(); ++f) {
    for (std::uint32_t l = boundary.face_first_loop[f]; l < boundary.face_first_loop[f + 1]; ++l) {
      auto& shell = corners[boundary.face_shells[f]];
      shell.insert(shell.end(), boundary.loop(l).begin(), boundary.loop(l).end());
    }
  }
  std::vector<Polytope> pieces;
  for (std::vector<PointId>& shell : corners) {
    std::sort(shell.begin(), shell.end());
    shell.erase(std::unique(shell.begin(), shell.end()), shell.end());
    std::vector<Point3> points;
    for (const PointId p : shell) {
      if (!boundary.points.is_exact(p)) return std::nullopt;
      points.push_back(boundary.points.rounded(p));
    }
    pieces.push_back(Polytope::hull_of(points, context));
  }
  return pieces;
}

Polytope hull_of_boundary(const Brep& boundary, const Context& context) {
  std::vector<PointId> corners = boundary.loop_vertices;
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return Polytope::hull_of(boundary.points, corners, context);
}

}  // namespace quoin
