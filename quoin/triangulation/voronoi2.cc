// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/voronoi2.h"

#include <algorithm>

namespace quoin {

RationalPoint2 circumcentre(const Point2& a, const Point2& b, const Point2& c) {
  const Rational ax(a.x);
  const Rational ay(a.y);
  const Rational bx = Rational(b.x) - ax;
  const Rational by = Rational(b.y) - ay;
  const Rational cx = Rational(c.x) - ax;
  const Rational cy = Rational(c.y) - ay;
  const Rational lift_b = bx * bx + by * by;
  const Rational lift_c = cx * cx + cy * cy;
  const Rational twice_area = Rational(2) * (bx * cy - by * cx);
  return {ax + (lift_b * cy - lift_c * by) / twice_area, ay + (lift_c * bx - lift_b * cx) / twice_area};
}

RationalPoint2 Voronoi2::vertex(DeloneCell2 cell) const {
  const auto corners = delone_->corners(cell);
  return circumcentre(delaunay_->point(corners[0]), delaunay_->point(corners[1]), delaunay_->point(corners[2]));
}

Point2 Voronoi2::rounded(DeloneCell2 cell) const {
  const RationalPoint2 exact = vertex(cell);
  return {exact.x.to_double(), exact.y.to_double()};
}

Rational Voronoi2::squared_radius(DeloneCell2 cell) const {
  const RationalPoint2 centre = vertex(cell);
  const Point2& p = delaunay_->point(delone_->corners(cell)[0]);
  const Rational dx = centre.x - Rational(p.x);
  const Rational dy = centre.y - Rational(p.y);
  return dx * dx + dy * dy;
}

VoronoiCell2 Voronoi2::cell(Vertex2 site) const {
  VoronoiCell2 result;
  if (delaunay_->dimension() < 2) return result;
  std::vector<DeloneCell2> around;
  delaunay_->links().for_edges_from(site, [&](Edge2 e) {
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
  Rational twice;
  RationalPoint2 from = vertex(polygon.corners.back());
  for (const DeloneCell2 corner : polygon.corners) {
    RationalPoint2 to = vertex(corner);
    twice += from.x * to.y - from.y * to.x;
    from = std::move(to);
  }
  return twice / Rational(2);
}

std::vector<VoronoiEdge2> Voronoi2::edges() const {
  std::vector<VoronoiEdge2> result;
  const auto line = delaunay_->line();
  for (std::size_t i = 1; i < line.size(); ++i) result.push_back({line[i - 1], line[i], {}, {}});
  const Triangulation2& links = delaunay_->links();
  for (std::uint32_t t = 0; t < links.triangle_count(); ++t) {
    for (unsigned slot = 0; slot < 3; ++slot) {
      const Edge2 e(Triangle2(t), slot);
      const Edge2 twin = links.twin(e);
      if (twin < e || links.is_infinite(e) || delone_->is_inner(links, e)) continue;
      // Across the edge, from its left to its right, its target comes to lie on the left.
      result.push_back({links.target(e), links.source(e), delone_->cell(e.triangle()), delone_->cell(twin.triangle())});
    }
  }
  return result;
}

}  // namespace quoin
