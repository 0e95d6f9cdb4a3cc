// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/voronoi2.h"

#include <algorithm>
#include <utility>

namespace quoin {

RationalPoint2 circumcentre(const Point2& a, const Point2& b, const Point2& c) {
  return power_centre({a, 0}, {b, 0}, {c, 0});
}

RationalPoint2 power_centre(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& c) {
  const Rational ax(a.point.x);
  const Rational ay(a.point.y);
  const Rational bx = Rational(b.point.x) - ax;
  const Rational by = Rational(b.point.y) - ay;
  const Rational cx = Rational(c.point.x) - ax;
  const Rational cy = Rational(c.point.y) - ay;
  Rational lift_b = bx * bx + by * by;
  Rational lift_c = cx * cx + cy * cy;
  if (b.weight != a.weight) lift_b -= Rational(b.weight) - Rational(a.weight);
  if (c.weight != a.weight) lift_c -= Rational(c.weight) - Rational(a.weight);
  const Rational twice_area = Rational(2) * (bx * cy - by * cx);
  return {ax + (lift_b * cy - lift_c * by) / twice_area, ay + (lift_c * bx - lift_b * cx) / twice_area};
}

RationalPoint2 Voronoi2::vertex(DeloneCell2 cell) const {
  const auto corners = delone_->corners(cell);
  const auto site = [this](Vertex2 v) { return WeightedPoint2{triangulation_.point(v), triangulation_.weight(v)}; };
  return power_centre(site(corners[0]), site(corners[1]), site(corners[2]));
}

Point2 Voronoi2::rounded(DeloneCell2 cell) const {
  const RationalPoint2 exact = vertex(cell);
  return {exact.x.to_double(), exact.y.to_double()};
}

Rational Voronoi2::squared_radius(DeloneCell2 cell) const {
  const RationalPoint2 centre = vertex(cell);
  const Vertex2 corner = delone_->corners(cell)[0];
  const Point2& p = triangulation_.point(corner);
  const Rational dx = centre.x - Rational(p.x);
  const Rational dy = centre.y - Rational(p.y);
  return dx * dx + dy * dy - Rational(triangulation_.weight(corner));
}

VoronoiCell2 Voronoi2::cell(Vertex2 site) const {
  VoronoiCell2 result;
  if (!has_cell(site)) {
    result.is_bounded = true;
    return result;
  }
  if (triangulation_.dimension() < 2) return result;
  std::vector<DeloneCell2> around;
  triangulation_.links().for_edges_from(site, [&](Edge2 e) {
    const DeloneCell2 cell = delone_->cell(e.triangle());
    if (around.empty() || around.back() != cell) around.push_back(cell);
  });
  if (around.size() > 1 && around.back() == around.front()) around.pop_back();
  const auto infinite = std::find(around.begin(), around.end(), DeloneCell2());
  result.is_bounded = infinite == around.end();
  if (!result.is_bounded) {
    std::rotate(around.begin(), infinite, around.end());
    around.erase(around.begin());
  }
  result.corners = std::move(around);
  return result;
}

std::optional<Rational> Voronoi2::area(Vertex2 site) const {
  const VoronoiCell2 polygon = cell(site);
  if (!polygon.is_bounded) return std::nullopt;
  if (polygon.corners.empty()) return Rational();
  Rational twice;
  RationalPoint2 from = vertex(polygon.corners.back());
  for (const DeloneCell2 corner : polygon.corners) {
    RationalPoint2 to = vertex(corner);
    twice += from.x * to.y - from.y * to.x;
    from = std::move(to);
  }
  return twice / Rational(2);
}

// Of an edge of the triangulation on the boundary of the cell to its left: where it ends, or the side of the cell that
// it begins.
Vertex2 Voronoi2::end_of_side(Edge2 e) const {
  const Triangulation2& links = triangulation_.links();
  while (!has_cell(links.target(e))) {
    e = Triangulation2::next(e);
    while (delone_->is_inner(links, e)) e = Triangulation2::next(links.twin(e));
  }
  return links.target(e);
}

std::vector<VoronoiEdge2> Voronoi2::edges() const {
  std::vector<VoronoiEdge2> result;
  Vertex2 before;
  for (const Vertex2 v : triangulation_.line()) {
    if (!has_cell(v)) continue;
    if (!before.is_none()) result.push_back({before, v, {}, {}});
    before = v;
  }
  const Triangulation2& links = triangulation_.links();
  for (std::uint32_t t = 0; t < links.triangle_count(); ++t) {
    for (unsigned slot = 0; slot < 3; ++slot) {
      const Edge2 e(Triangle2(t), slot);
      const Edge2 twin = links.twin(e);
      if (twin < e || links.is_infinite(e) || delone_->is_inner(links, e)) continue;
      const DeloneCell2 from = delone_->cell(e.triangle());
      const DeloneCell2 to = delone_->cell(twin.triangle());
      // Of a side in several parts the one that is first in its direction about the cell of the smaller number.
      const Edge2 side = from < to ? e : twin;
      if (!has_cell(links.source(side))) continue;
      Vertex2 source = links.source(side);
      Vertex2 target = end_of_side(side);
      if (side != e) std::swap(source, target);
      // Across the edge, from its left to its right, its target comes to lie on the left.
      result.push_back({target, source, from, to});
    }
  }
  return result;
}

}  // namespace quoin
