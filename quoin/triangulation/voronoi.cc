// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/voronoi.h"

#include <algorithm>
#include <map>

#include "quoin/base/error.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/triangulation/affine_basis.h"
#include "quoin/triangulation/voronoi_volume.h"

namespace quoin {

namespace {

/// Where the planes 2 x . p = lift and so on meet, by Cramer's rule.
RationalPoint3 meeting_point(const std::array<RationalPoint3, 3>& vectors, const std::array<Rational, 3>& lifts) {
  const auto& [p, q, r] = vectors;
  const RationalPoint3 qr = cross(q, r);
  const RationalPoint3 sum = qr * lifts[0] + cross(r, p) * lifts[1] + cross(p, q) * lifts[2];
  return sum * (Rational(1) / (Rational(2) * dot(p, qr)));
}

/// Of one to three affinely independent points: the point of the same power of all in their affine hull.
RationalPoint3 flat_power_centre(std::span<const Point3> points, std::span<const double> weights) {
  if (points.size() == 1) return exact_point(points[0]);
  const RationalPoint3 origin = exact_point(points[0]);
  std::array<RationalPoint3, 3> vectors;
  std::array<Rational, 3> lifts;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    vectors[i] = exact_point(points[i + 1]) - origin;
    lifts[i] = dot(vectors[i], vectors[i]) - (Rational(weights[i + 1]) - Rational(weights[0]));
  }
  if (points.size() == 2) return origin + vectors[0] * (lifts[0] / (Rational(2) * dot(vectors[0], vectors[0])));
  vectors[2] = cross(vectors[0], vectors[1]);  // the plane through the origin across it
  return origin + meeting_point(vectors, lifts);
}

}  // namespace

RationalPoint3 circumcentre(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const RationalPoint3 origin = exact_point(a);
  const std::array<RationalPoint3, 3> v{exact_point(b) - origin, exact_point(c) - origin, exact_point(d) - origin};
  return origin + meeting_point(v, {dot(v[0], v[0]), dot(v[1], v[1]), dot(v[2], v[2])});
}

RationalPoint3 power_centre(const std::array<Point3, 4>& points, const std::array<double, 4>& weights) {
  const RationalPoint3 origin = exact_point(points[0]);
  std::array<RationalPoint3, 3> vectors;
  std::array<Rational, 3> lifts;
  for (std::size_t i = 0; i < 3; ++i) {
    vectors[i] = exact_point(points[i + 1]) - origin;
    lifts[i] = dot(vectors[i], vectors[i]) - (Rational(weights[i + 1]) - Rational(weights[0]));
  }
  return origin + meeting_point(vectors, lifts);
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
  const TriangulationView3& t = triangulation_;
  const auto size = static_cast<std::size_t>(dimension()) + 1;
  std::array<Point3, 4> p;
  std::array<double, 4> weights{};
  for (std::size_t i = 0; i < size; ++i) {
    p[i] = t.point(v[i]);
    weights[i] = t.weight(v[i]);
  }
  if (size < 4) return flat_power_centre(std::span(p).first(size), std::span(weights).first(size));
  return t.is_weighted() ? power_centre(p, weights) : circumcentre(p[0], p[1], p[2], p[3]);
}

// The corner at the other end of the Delone edge, of which this one of the triangulation is a part.
std::uint32_t Voronoi3::end_of_edge(std::uint32_t vertex, std::uint32_t neighbour) const {
  std::uint32_t before = vertex;
  std::uint32_t end = neighbour;
  while (!has_cell(end)) {
    const Point3 from = triangulation_.point(before);
    const Point3 here = triangulation_.point(end);
    for (const std::uint32_t next : stars_.neighbours(end)) {
      const Point3 to = triangulation_.point(next);
      const bool is_ahead = lexicographically_less(from, here) == lexicographically_less(here, to);
      if (next == before || !is_ahead || normal_axis(from, here, to) < 3) continue;
      before = end;
      end = next;
      break;
    }
  }
  return end;
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
  if (!has_cell(vertex) || dimension() == 0) return {};
  std::vector<VoronoiFacet> all = dimension() == 3   ? facets_in_space(vertex)
                                  : dimension() == 2 ? facets_across_plane(vertex)
                                                     : facets_across_line(vertex);
  for (VoronoiFacet& facet : all) facet.neighbour = end_of_edge(vertex, facet.neighbour);
  std::ranges::sort(all, {}, &VoronoiFacet::neighbour);
  return all;
}

std::vector<VoronoiFacet> Voronoi3::facets_in_space(std::uint32_t vertex) const {
  std::map<std::uint32_t, std::uint32_t> cell_of;  // by neighbour, some cell of the edge
  for (const std::uint32_t c : stars_.star(vertex)) {
    for (const std::uint32_t v : triangulation_.cells()[c].vertices) {
      if (v != vertex && v != vertex_at_infinity) cell_of[v] = c;
    }
  }
  std::vector<VoronoiFacet> all;
  for (const auto& [neighbour, cell] : cell_of) {
    VoronoiFacet next = facet(vertex, neighbour, cell);
    if (next.is_bounded ? next.corners.size() < 3 : next.corners.size() < 2 && is_ray(vertex, neighbour, cell))
      continue;
    all.push_back(std::move(next));
  }
  return all;
}

std::vector<VoronoiFacet> Voronoi3::facets_across_plane(std::uint32_t vertex) const {
  std::vector<VoronoiFacet> all;
  for (const std::uint32_t c : stars_.star(vertex)) {
    // About the vertex, the triangle is followed by that across the edge to its last vertex.
    const TriangulationCell& cell = triangulation_.cells()[c];
    const unsigned slot = slot_of(cell, vertex);
    VoronoiFacet next{cell.vertices[(slot + 2) % 3], false, {}};
    if (next.neighbour == vertex_at_infinity) continue;
    for (const std::uint32_t side : {c, cell.neighbours[(slot + 1) % 3] >> 2}) {
      if (triangulation_.is_ghost(side)) continue;
      next.corners.push_back(corner(side));
      next.cells.push_back(side);
    }
    if (next.corners.front() == next.corners.back() && next.corners.size() == 2) continue;
    all.push_back(std::move(next));
  }
  return all;
}

std::vector<VoronoiFacet> Voronoi3::facets_across_line(std::uint32_t vertex) const {
  std::vector<VoronoiFacet> all;
  for (const std::uint32_t c : stars_.star(vertex)) {
    if (triangulation_.is_ghost(c)) continue;
    const TriangulationCell& cell = triangulation_.cells()[c];
    all.push_back({cell.vertices[1 - slot_of(cell, vertex)], false, {corner(c)}, {c}});
  }
  return all;
}

std::optional<Rational> Voronoi3::volume(std::uint32_t vertex) const {
  if (!has_cell(vertex)) return Rational();
  if (is_unbounded(vertex)) return std::nullopt;
  return voronoi_volume(triangulation_, vertex, stars_.star(vertex));
}

std::optional<Rational> Voronoi3::squared_section(std::uint32_t vertex) const {
  if (dimension() == 3) throw InputError("the section of a Voronoi cell with the plane of points that are in none");
  if (!has_cell(vertex)) return Rational();
  if (dimension() == 0) return Rational(1);
  if (stars_.is_on_hull(vertex)) return std::nullopt;
  const std::vector<VoronoiFacet> sides = facets(vertex);
  if (dimension() == 1) {
    const RationalPoint3 way = sides[1].corners[0] - sides[0].corners[0];
    return dot(way, way);
  }
  const RationalPoint3 apex = exact_point(triangulation_.point(vertex));
  RationalPoint3 twice_area;  // along the normal of the plane
  for (const VoronoiFacet& side : sides)
    twice_area = twice_area + cross(side.corners[0] - apex, side.corners[1] - apex);
  return dot(twice_area, twice_area) / Rational(4);
}

Rational Voronoi3::volume(std::uint32_t vertex, std::span<const VoronoiFacet> facets) const {
  const RationalPoint3 apex = exact_point(triangulation_.point(vertex));
  Rational sum;  // twelve times
  for (const VoronoiFacet& facet : facets) {
    // The facet is in the plane of the x with 2 (x - apex) . way = lift, which is the square of the way to the
    // neighbour less what it weighs more: the cone's volume is a sixth of this times the facet's area over the way's
    // length. Area over length is the same for the projections of both on an axis.
    const RationalPoint3 way = exact_point(triangulation_.point(facet.neighbour)) - apex;
    const Rational lift =
        dot(way, way) - (Rational(triangulation_.weight(facet.neighbour)) - Rational(triangulation_.weight(vertex)));
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
    sum += twice_area * (lift / way[axis]);
  }
  return sum / Rational(12);
}

}  // namespace quoin
