// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/polytope.h"

#include <utility>

#include "quoin/base/error.h"
#include "quoin/polytope/as_doubles.h"

namespace quoin {

Polytope Polytope::of_hull(const ConvexHull& hull) {
  if (hull.dimension < 0) throw InputError("there are no points: their hull is no polytope");
  Polytope result;
  result.sources_ = hull.vertices;
  // Vertices by their numbers.
  std::vector<std::uint32_t> place(hull.vertices.back() + std::size_t{1}, none);
  for (std::uint32_t v = 0; v < hull.vertices.size(); ++v) place[hull.vertices[v]] = v;
  std::vector<std::uint32_t> corners;
  corners.reserve(hull.corners.size());
  for (const std::uint32_t corner : hull.corners) corners.push_back(place[corner]);
  result.link(hull.dimension, hull.vertices.size(), {corners, hull.facet_begin});
  return result;
}

Polytope Polytope::hull_of(std::span<const Point3> points, const Context& context) {
  Polytope result = of_hull(convex_hull(points, context));
  result.points_.reserve(result.sources_.size());
  for (const std::uint32_t v : result.sources_) result.points_.push_back(points[v]);
  result.set_vectors();
  return result;
}

Polytope Polytope::hull_of(std::span<const RationalPoint3> points, const Context& context) {
  if (const auto doubles = as_doubles(points, &context)) return hull_of(*doubles, context);
  Polytope result = of_hull(convex_hull(points, context));
  std::vector<RationalPoint3> vertices;
  for (const std::uint32_t v : result.sources_) {
    if (vertices.size() % 256 == 0) context.poll();
    vertices.push_back(points[v]);
  }
  result.set_vertices(std::move(vertices), context);
  return result;
}

Polytope Polytope::hull_of(const Constructions& table, std::span<const PointId> points, const Context& context) {
  Polytope result = of_hull(convex_hull(table, points, context));
  std::vector<RationalPoint3> vertices;
  for (const std::uint32_t v : result.sources_) {
    if (vertices.size() % 256 == 0) context.poll();
    vertices.push_back(table.exact(points[v]));
  }
  result.set_vertices(std::move(vertices), context);
  return result;
}

void Polytope::set_vertices(std::vector<RationalPoint3> exact, const Context& context) {
  const auto poll_for_some = [&](std::size_t i) {
    if (i % 256 == 0) context.poll();
  };
  if (auto doubles = as_doubles(exact, &context)) {
    points_ = std::move(*doubles);
    set_vectors();
    return;
  }
  std::vector<RationalPoint3> vectors;
  vectors.reserve(halfedges().size());
  for (const Halfedge& h : halfedges()) {
    poll_for_some(vectors.size());
    vectors.push_back(exact[h.head] - exact[h.tail]);
  }
  std::vector<Point3> rounded;
  rounded.reserve(exact.size());
  for (const RationalPoint3& p : exact) {
    poll_for_some(rounded.size());
    rounded.push_back({p.x.to_double(), p.y.to_double(), p.z.to_double()});
  }
  vectors_ = std::make_shared<const std::vector<RationalPoint3>>(std::move(vectors));
  vertices_ = std::make_shared<const RationalVertices>(RationalVertices{std::move(exact), std::move(rounded)});
  for (const RationalPoint3& v : *vectors_) {
    poll_for_some(edges_.size());
    edges_.push_back(edge_vector(v));
  }
  set_vectors();
}

Polytope reflected(const Polytope& p) {
  Polytope result(p);
  result.reflect();
  if (p.vertices_ == nullptr) return result;
  // Edges have found their negatives among those of p.
  Polytope::RationalVertices vertices = *p.vertices_;
  for (RationalPoint3& v : vertices.exact) v = v * Rational(-1);
  for (Point3& v : vertices.rounded) v = {-v.x, -v.y, -v.z};
  result.vertices_ = std::make_shared<const Polytope::RationalVertices>(std::move(vertices));
  return result;
}

}  // namespace quoin
