// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/voronoi.h"

#include <algorithm>
#include <map>

#include "quoin/base/error.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/triangulation/voronoi_volume.h"

namespace quoin {

RationalPoint3 circumcentre(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const RationalPoint3 origin = exact_point(a);
  const RationalPoint3 p = exact_point(b) - origin;
  const RationalPoint3 q = exact_point(c) - origin;
  const RationalPoint3 r = exact_point(d) - origin;
  // The planes 2 x . p = p . p and so on, by Cramer's rule.
  const RationalPoint3 qr = cross(q, r);
  const RationalPoint3 sum = qr * dot(p, p) + cross(r, p) * dot(q, q) + cross(p, q) * dot(r, r);
  return origin + sum * (Rational(1) / (Rational(2) * dot(p, qr)));
}

Voronoi3::Voronoi3(const Delaunay3& triangulation) : triangulation_(triangulation), stars_(triangulation) {
  if (triangulation.dimension() < 3) throw InputError("a Voronoi diagram of space of points that lie in a plane");
}

void Voronoi3::keep_corners(const Context& context) {
  std::vector<RationalPoint3> corners(triangulation_.cells().size());
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (c % 64 == 0) context.poll();
    if (!triangulation_.is_ghost(c)) corners[c] = corner(c);
  }
  corners_ = std::move(corners);
}

RationalPoint3 Voronoi3::corner(std::size_t cell) const {
  if (!corners_.empty()) return corners_[cell];
  const auto& v = triangulation_.cells()[cell].vertices;
  const Delaunay3& t = triangulation_;
  return circumcentre(t.point(v[0]), t.point(v[1]), t.point(v[2]), t.point(v[3]));
}

VoronoiFacet Voronoi3::facet(std::uint32_t vertex, std::uint32_t neighbour, std::uint32_t cell) const {
  const std::span<const TriangulationCell> cells = triangulation_.cells();
  std::vector<std::uint32_t> ring;
  for_each_around_edge(cells, cell, slot_of(cells[cell], vertex), slot_of(cells[cell], neighbour),
                       [&](std::uint32_t c) { ring.push_back(c); });
  VoronoiFacet facet{neighbour, true, {}};
  // An unbounded ring begins behind its ghosts, which follow each other.
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (triangulation_.is_ghost(ring[i]) && !triangulation_.is_ghost(ring[(i + 1) % ring.size()])) {
      std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>((i + 1) % ring.size()), ring.end());
      facet.is_bounded = false;
      break;
    }
  }
  for (const std::uint32_t c : ring) {
    if (triangulation_.is_ghost(c)) continue;
    RationalPoint3 next = corner(c);
    if (!facet.corners.empty() && facet.corners.back() == next) continue;
    facet.corners.push_back(std::move(next));
    facet.cells.push_back(c);
  }
  if (facet.is_bounded && facet.corners.size() > 1 && facet.corners.front() == facet.corners.back()) {
    facet.corners.pop_back();
    facet.cells.pop_back();
  }
  return facet;
}

// Where the two facets of the hull at the edge lie in one plane, the rays of an unbounded facet are parallel: with one
// corner they are the same.
bool Voronoi3::is_ray(std::uint32_t vertex, std::uint32_t neighbour, std::uint32_t cell) const {
  const std::span<const TriangulationCell> cells = triangulation_.cells();
  std::vector<std::uint32_t> corners;  // of both
  for_each_around_edge(cells, cell, slot_of(cells[cell], vertex), slot_of(cells[cell], neighbour),
                       [&](std::uint32_t c) {
                         if (!triangulation_.is_ghost(c)) return;
                         corners.insert(corners.end(), cells[c].vertices.begin(), cells[c].vertices.begin() + 3);
                       });
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  const auto point = [&](std::size_t i) { return triangulation_.point(corners[i]); };
  return corners.size() == 4 && orientation(point(0), point(1), point(2), point(3)) == Sign::zero;
}

std::vector<VoronoiFacet> Voronoi3::facets(std::uint32_t vertex) const {
  std::map<std::uint32_t, std::uint32_t> cell_of;  // by neighbour, some cell of the edge
  for (const std::uint32_t c : stars_.star(vertex)) {
    for (const std::uint32_t v : triangulation_.cells()[c].vertices) {
      if (v != vertex && v != vertex_at_infinity) cell_of[v] = c;
    }
  }
  std::vector<VoronoiFacet> all;
  for (const auto& [neighbour, cell] : cell_of) {
    VoronoiFacet next = facet(vertex, neighbour, cell);
    if (next.is_bounded ? next.corners.size() > 2 : next.corners.size() > 1 || !is_ray(vertex, neighbour, cell))
      all.push_back(std::move(next));
  }
  return all;
}

std::optional<Rational> Voronoi3::volume(std::uint32_t vertex) const {
  if (is_unbounded(vertex)) return std::nullopt;
  return voronoi_volume(triangulation_, vertex, stars_.star(vertex));
}

Rational Voronoi3::volume(std::uint32_t vertex, std::span<const VoronoiFacet> facets) const {
  const RationalPoint3 apex = exact_point(triangulation_.point(vertex));
  Rational sum;  // twelve times
  for (const VoronoiFacet& facet : facets) {
    // The facet is in the plane halfway to the neighbour, at right angles to the way there: the cone's volume is a
    // sixth of the square of this way times the facet's area over its length. Area over length is the same for the
    // projections of both on an axis.
    const RationalPoint3 way = exact_point(triangulation_.point(facet.neighbour)) - apex;
    unsigned axis = 0;
    while (way[axis].sign() == Sign::zero) ++axis;
    const unsigned u = (axis + 1) % 3;
    const unsigned v = (axis + 2) % 3;
    Rational twice_area;
    for (std::size_t i = 0; i < facet.corners.size(); ++i) {
      const RationalPoint3& from = facet.corners[i];
      const RationalPoint3& to = facet.corners[(i + 1) % facet.corners.size()];
      twice_area += from[u] * to[v] - from[v] * to[u];
    }
    sum += twice_area * (dot(way, way) / way[axis]);
  }
  return sum / Rational(12);
}

}  // namespace quoin
