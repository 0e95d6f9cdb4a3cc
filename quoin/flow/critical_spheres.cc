// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/critical_spheres.h"

#include <vector>

namespace quoin {

namespace {

std::vector<Point3> points_of(const Delaunay3& triangulation) {
  std::vector<Point3> points;
  points.reserve(triangulation.vertex_count());
  for (std::uint32_t v = 0; v < triangulation.vertex_count(); ++v) points.push_back(triangulation.point(v));
  return points;
}

}  // namespace

CriticalFace CriticalFace::edge(const FlowCells& flow, std::uint32_t cell, unsigned edge) {
  const auto& v = flow.cells()[cell].vertices;
  return {{v[edge_slots[edge][0]], v[edge_slots[edge][1]]}, 2};
}

CriticalFace CriticalFace::facet(const FlowCells& flow, CellFacet facet) {
  const auto& v = flow.cells()[facet.cell].vertices;
  const auto& [a, b, c] = facet_slots[facet.slot];
  return {{v[a], v[b], v[c]}, 3};
}

CriticalFace CriticalFace::simplex(const FlowCells& flow, std::uint32_t cell) {
  return {flow.cells()[cell].vertices, 4};
}

CriticalSpheres::CriticalSpheres(const Delaunay3& triangulation) : spheres_(points_of(triangulation)) {}

}  // namespace quoin
