// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/proximity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "quoin/kernel/closest_point.h"
#include "quoin/number/interval.h"
#include "quoin/polytope/difference_body.h"

namespace quoin {

namespace {

using closest::ClosestPoint;
using Exact = DifferenceBody::Exact;

Exact as_vector(const RationalPoint3& p) {
  return {p.x, p.y, p.z};
}
RationalPoint3 as_point(const Exact& v) {
  return {v[0], v[1], v[2]};
}
/// The point is of the polygon, or of all the body, of these vertices.
void set_witness(PolytopeDistance& result, const DifferenceBody& body, std::span<const std::uint32_t> vertices,
                 const ClosestPoint<Rational>& point) {
  RationalPoint3 on_a{0, 0, 0};
  RationalPoint3 on_b{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = vertices[point.corners[i]];
    on_a = on_a + body.point_of_a(v) * point.weights[i];
    on_b = on_b + body.point_of_b(v) * point.weights[i];
  }
  result.witness = {on_a, on_b};
}

/// The facet plane nearest to the origin: exactly among those whose enclosed distances reach down to the least upper
/// end.
std::pair<std::size_t, Rational> nearest_plane(const DifferenceBody& body, const Context& context) {
  std::vector<Interval> depths;
  double reach = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < body.facet_count(); ++f) {
    if (f % 256 == 0) context.poll();
    depths.push_back(body.enclosed_squared_depth(f));
    reach = std::min(reach, depths.back().upper());
  }
  std::optional<std::pair<std::size_t, Rational>> best;
  for (std::size_t f = 0; f < depths.size(); ++f) {
    if (depths[f].lower() > reach) continue;
    context.poll();
    Rational depth = body.exact_squared_depth(f);
    if (!best || depth < best->second) best.emplace(f, std::move(depth));
  }
  return *best;
}

/// Of facets that the origin is outside of, or in the plane of. The one that seems nearest is, if the plane that stands
/// on its nearest point supports the body; else all are compared exactly.
std::pair<std::size_t, ClosestPoint<Rational>> nearest_facet(const DifferenceBody& body,
                                                             std::span<const std::size_t> facets,
                                                             const Context& context) {
  std::size_t best = facets[0];
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t f : facets) {
    const double value = body.approximate_squared_distance(f);
    if (value < least) {
      least = value;
      best = f;
    }
  }
  ClosestPoint<Rational> point = body.exact_closest(best);
  if (body.supports(point.point, context)) return {best, std::move(point)};
  for (const std::size_t f : facets) {
    context.poll();
    ClosestPoint<Rational> other = body.exact_closest(f);
    if (!(other.squared_length < point.squared_length)) continue;
    best = f;
    point = std::move(other);
  }
  return {best, std::move(point)};
}

void set_penetration(PolytopeDistance& result, const DifferenceBody& body, const Context& context) {
  auto [f, depth] = nearest_plane(body, context);
  const Exact n = body.exact_normal(f);
  const Rational scale = closest::dot(n, body.exact(body.facet(f)[0])) / closest::dot(n, n);
  // The foot of the origin on the nearest facet plane lies in the facet.
  const ClosestPoint<Rational> foot = body.exact_closest(f);
  set_witness(result, body, body.facet(f), foot);
  result.squared_penetration = std::move(depth);
  result.separation = as_point({-(n[0] * scale), -(n[1] * scale), -(n[2] * scale)});
}

/// Of two that are parallel to one plane, so that neither overlaps the other in space.
PolytopeDistance distance_in_plane(const DifferenceBody& body) {
  PolytopeDistance result;
  const ClosestPoint<Rational> point = body.exact_closest();
  result.relation = point.squared_length.sign() == Sign::zero ? Proximity::touching : Proximity::apart;
  constexpr std::array<std::uint32_t, 2> ends{0, 1};
  set_witness(result, body, body.dimension() == 2 ? body.facet(0) : ends, point);
  result.squared_distance = point.squared_length;
  return result;
}

/// Normal to all of a polytope that is no solid.
RationalPoint3 normal_of_flat(const Polytope& p) {
  if (p.dimension() == 0) return {0, 0, 1};
  const RationalPoint3 along = exact_vector(p.edge(0));
  if (p.dimension() == 1) {
    return along.x.sign() == Sign::zero && along.y.sign() == Sign::zero ? RationalPoint3{1, 0, 0}
                                                                        : RationalPoint3{along.y, -along.x, 0};
  }
  const std::uint32_t h = p.first_halfedge(0);
  return cross(exact_vector(p.edge(h)), exact_vector(p.edge(p.halfedges()[h].next)));
}

}  // namespace

PolytopeDistance polytope_distance(const Polytope& a, const Polytope& b, const Context& context) {
  const DifferenceBody body(a, b, context);
  if (body.dimension() < 3) return distance_in_plane(body);
  PolytopeDistance result;
  std::vector<std::size_t> outer;
  std::vector<std::size_t> through;
  for (std::size_t f = 0; f < body.facet_count(); ++f) {
    if (f % 256 == 0) context.poll();
    const Sign sign = body.depth_sign(f);
    if (sign == Sign::negative) outer.push_back(f);
    if (sign == Sign::zero) through.push_back(f);
  }
  if (outer.empty() && through.empty()) {
    result.relation = Proximity::overlapping;
    set_penetration(result, body, context);
    return result;
  }
  result.relation = outer.empty() ? Proximity::touching : Proximity::apart;
  const auto [f, point] = nearest_facet(body, outer.empty() ? through : outer, context);
  set_witness(result, body, body.facet(f), point);
  result.squared_distance = point.squared_length;
  return result;
}

PolytopeWidth polytope_width(const Polytope& p, const Context& context) {
  PolytopeWidth result;
  const auto add_face = [](std::vector<std::uint32_t>& face, std::uint32_t v) {
    if (std::find(face.begin(), face.end(), v) == face.end()) face.push_back(v);
  };
  if (p.dimension() < 3) {
    result.direction = normal_of_flat(p);
    for (std::uint32_t v = 0; v < p.vertex_count(); ++v) {
      result.faces[0].push_back(v);
      result.faces[1].push_back(v);
    }
    return result;
  }
  const DifferenceBody body(p, p, context);
  auto [f, depth] = nearest_plane(body, context);
  result.squared_width = std::move(depth);
  result.direction = as_point(body.exact_normal(f));
  for (const std::uint32_t v : body.facet(f)) {
    add_face(result.faces[0], body.sources(v)[0]);
    add_face(result.faces[1], body.sources(v)[1]);
  }
  for (auto& face : result.faces) std::sort(face.begin(), face.end());
  return result;
}

PolytopeDiameter polytope_diameter(const Polytope& p, const Context& context) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  if (p.dimension() < 3) {
    for (std::uint32_t i = 0; i < p.vertex_count(); ++i) {
      for (std::uint32_t k = 0; k < i; ++k) pairs.push_back({k, i});
    }
  } else {
    const DifferenceBody body(p, p, context);
    for (std::uint32_t v = 0; v < body.vertex_count(); ++v) pairs.push_back(body.sources(v));
  }
  const auto exact = [&](const std::array<std::uint32_t, 2>& pair) {
    return as_vector(p.exact_vertex(pair[0]) - p.exact_vertex(pair[1]));
  };
  const auto enclosed = [&](const std::array<std::uint32_t, 2>& pair) -> closest::Vector<Interval> {
    if (p.is_rational()) {
      const Exact d = exact(pair);
      return {Interval::around(d[0]), Interval::around(d[1]), Interval::around(d[2])};
    }
    const Point3& a = p.vertex(pair[0]);
    const Point3& b = p.vertex(pair[1]);
    return {Interval(a.x) - Interval(b.x), Interval(a.y) - Interval(b.y), Interval(a.z) - Interval(b.z)};
  };
  std::vector<Interval> lengths;
  double reach = 0;
  for (const auto& pair : pairs) {
    const auto d = enclosed(pair);
    lengths.push_back(closest::dot(d, d));
    reach = std::max(reach, lengths.back().lower());
  }
  PolytopeDiameter result;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (lengths[i].upper() < reach) continue;
    const Exact d = exact(pairs[i]);
    Rational length = closest::dot(d, d);
    if (length <= result.squared_diameter) continue;
    result.squared_diameter = std::move(length);
    result.vertices = pairs[i];
  }
  return result;
}

}  // namespace quoin
