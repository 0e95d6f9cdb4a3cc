// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/nearest_face.h"

#include <algorithm>

namespace quoin {

namespace {

Rational square_distance(const RationalPoint3& a, const Point3& b) {
  const RationalPoint3 v = a - exact_point(b);
  return dot(v, v);
}

bool has_all(std::span<const std::uint32_t> vertices, const std::vector<std::uint32_t>& wanted) {
  return std::all_of(wanted.begin(), wanted.end(),
                     [&](std::uint32_t v) { return std::find(vertices.begin(), vertices.end(), v) != vertices.end(); });
}

std::uint32_t other_end(const DeloneFaces& faces, std::uint32_t edge, std::uint32_t vertex) {
  const std::array<std::uint32_t, 2> ends = faces.edge(edge);
  return ends[0] == vertex ? ends[1] : ends[0];
}

}  // namespace

DeloneFace face_of_edges(const DeloneFaces& faces, std::uint32_t vertex, std::span<const std::uint32_t> edges) {
  if (edges.empty()) return {0, vertex};
  if (edges.size() == 1) return {1, edges[0]};
  std::vector<std::uint32_t> wanted;
  for (const std::uint32_t e : edges) wanted.push_back(other_end(faces, e, vertex));
  for (const RingPolygon& g : faces.ring(edges[0])) {
    if (edges.size() == 2 && has_all(faces.polygon(g.polygon), wanted)) return {2, g.polygon};
    for (const std::uint32_t c : faces.cells_of_polygon(g.polygon)) {
      if (edges.size() > 2 && c != DeloneFaces::outside && has_all(faces.cell(c), wanted)) return {3, c};
    }
  }
  return {0, vertex};
}

DeloneFace nearest_face(const FlowComplex& flow, const RationalPoint3& place) {
  const DeloneFaces& faces = flow.faces();
  std::uint32_t nearest = 0;
  Rational distance = square_distance(place, flow.point(nearest));
  std::vector<std::uint32_t> ties;
  for (bool is_nearest = false; !is_nearest;) {
    is_nearest = true;
    ties.clear();
    const std::uint32_t from = nearest;
    for (const std::uint32_t e : faces.edges_of_vertex(from)) {
      const std::uint32_t q = other_end(faces, e, from);
      const Rational other = square_distance(place, flow.point(q));
      if (other == distance && is_nearest) ties.push_back(e);
      if (other >= distance) continue;
      is_nearest = false;
      nearest = q;
      distance = other;
    }
  }
  return face_of_edges(faces, nearest, ties);
}

}  // namespace quoin
