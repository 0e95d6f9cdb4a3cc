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
#include "quoin/polytope/minkowski_sum.h"

namespace quoin {

namespace {

using closest::ClosestPoint;
using Exact = closest::Vector<Rational>;
using Rounded = closest::Vector<double>;

Exact as_vector(const RationalPoint3& p) {
  return {p.x, p.y, p.z};
}
RationalPoint3 as_point(const Exact& v) {
  return {v[0], v[1], v[2]};
}
Polytope reflected(const Polytope& p, const Context& context) {
  std::vector<Point3> points;
  for (std::uint32_t v = 0; v < p.vertex_count(); ++v) {
    const Point3& q = p.vertex(v);
    points.push_back({-q.x, -q.y, -q.z});
  }
  return Polytope::hull_of(points, context);
}

/// All differences of a point of A and a point of B, and where the origin is to its facets.
class DifferenceBody {
 public:
  DifferenceBody(const Polytope& a, const Polytope& b, const Context& context)
      : a_(a), b_(reflected(b, context)), sum_(minkowski_sum(a_, b_, context)) {}

  std::size_t facet_count() const { return sum_.facet_count(); }
  std::size_t vertex_count() const { return sum_.vertices.size(); }
  std::span<const std::uint32_t> facet(std::size_t f) const { return sum_.facet(f); }
  /// Vertices of the two polytopes that a vertex is the difference of. B's keep their numbers: those of a reflected
  /// polytope are in the order of the points it was made of.
  const std::array<std::uint32_t, 2>& sources(std::uint32_t v) const { return sum_.vertices[v]; }
  RationalPoint3 point_of_a(std::uint32_t v) const { return exact_point(a_.vertex(sources(v)[0])); }
  RationalPoint3 point_of_b(std::uint32_t v) const { return exact_point(b_.vertex(sources(v)[1])) * Rational(-1); }

  /// Positive: the origin is inside of the facet's plane.
  Sign depth_sign(std::size_t f) const {
    const auto corners = facet(f);
    const std::array<EdgeVector, 3> v{vector(corners[0]), vector(corners[1]), vector(corners[2])};
    return determinant(rounded(v[0]), rounded(v[1]), rounded(v[2]),
                       [&] { return exact_determinant(v[0], v[1], v[2]); });
  }

  Exact exact(std::uint32_t v) const { return as_vector(point_of_a(v) - point_of_b(v)); }
  Rounded approximate(std::uint32_t v) const {
    const Vector3 d = rounded(vector(v));
    return {d.x, d.y, d.z};
  }
  closest::Vector<Interval> enclosed(std::uint32_t v) const {
    const Point3& p = a_.vertex(sources(v)[0]);
    const Point3& q = b_.vertex(sources(v)[1]);
    return {Interval(p.x) + Interval(q.x), Interval(p.y) + Interval(q.y), Interval(p.z) + Interval(q.z)};
  }
  Exact exact_normal(std::size_t f) const {
    return normal_of<Exact>(f, [&](std::uint32_t v) { return exact(v); });
  }
  Rounded approximate_normal(std::size_t f) const {
    return normal_of<Rounded>(f, [&](std::uint32_t v) { return approximate(v); });
  }
  ClosestPoint<Rational> exact_closest(std::size_t f) const {
    std::vector<Exact> polygon;
    for (const std::uint32_t v : facet(f)) polygon.push_back(exact(v));
    return closest::on_polygon<Rational>(polygon, exact_normal(f));
  }
  double approximate_squared_distance(std::size_t f) const {
    polygon_.clear();
    for (const std::uint32_t v : facet(f)) polygon_.push_back(approximate(v));
    const double square = closest::on_polygon<double>(polygon_, approximate_normal(f)).squared_length;
    return std::isnan(square) ? 0 : square;
  }
  /// Of the plane; unbounded where a normal may be zero.
  Interval enclosed_squared_depth(std::size_t f) const {
    using Enclosed = closest::Vector<Interval>;
    const Enclosed n = normal_of<Enclosed>(f, [&](std::uint32_t v) { return enclosed(v); });
    const Interval height = closest::dot(n, enclosed(facet(f)[0]));
    const Interval square = closest::dot(n, n);
    return square.lower() > 0 ? height * height / square : Interval::unbounded();
  }
  Rational exact_squared_depth(std::size_t f) const {
    const Exact n = exact_normal(f);
    const Rational height = closest::dot(n, exact(facet(f)[0]));
    return height * height / closest::dot(n, n);
  }
  /// No vertex is beyond the plane through the point that stands on it.
  bool supports(const Exact& point, const Context& context) const {
    const Rounded x{point[0].to_double(), point[1].to_double(), point[2].to_double()};
    for (std::uint32_t v = 0; v < sum_.vertices.size(); ++v) {
      if (v % 256 == 0) context.poll();
      const Rounded y = approximate(v);
      double value = 0;
      double size = 0;
      double below_range = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        value += x[axis] * (y[axis] - x[axis]);
        const double reach = std::fabs(y[axis]) + std::fabs(x[axis]);
        size += std::fabs(x[axis]) * reach;
        below_range += 0x1p-1000 * reach + 0x1p-1000;
      }
      // Five roundings of each term; x may lose bits below the range of doubles, and so may products.
      if (value > 16 * 0x1p-53 * size + below_range) continue;
      if (closest::dot(point, closest::difference(exact(v), point)).sign() == Sign::negative) return false;
    }
    return true;
  }

 private:
  EdgeVector vector(std::uint32_t v) const {
    const Point3& q = b_.vertex(sources(v)[1]);
    return {{-q.x, -q.y, -q.z}, a_.vertex(sources(v)[0])};
  }
  template <class Vector, class Corner>
  Vector normal_of(std::size_t f, const Corner& corner) const {
    const auto corners = facet(f);
    const Vector origin = corner(corners[0]);
    return closest::cross(closest::difference(corner(corners[1]), origin),
                          closest::difference(corner(corners[2]), origin));
  }

  const Polytope& a_;
  Polytope b_;
  PolytopeSum sum_;
  mutable std::vector<Rounded> polygon_;  // scratch
};

void set_witness(PolytopeDistance& result, const DifferenceBody& body, std::size_t f,
                 const ClosestPoint<Rational>& point) {
  RationalPoint3 on_a{0, 0, 0};
  RationalPoint3 on_b{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = body.facet(f)[point.corners[i]];
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
  set_witness(result, body, f, foot);
  result.squared_penetration = std::move(depth);
  result.separation = as_point({-(n[0] * scale), -(n[1] * scale), -(n[2] * scale)});
}

}  // namespace

PolytopeDistance polytope_distance(const Polytope& a, const Polytope& b, const Context& context) {
  const DifferenceBody body(a, b, context);
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
  set_witness(result, body, f, point);
  result.squared_distance = point.squared_length;
  return result;
}

PolytopeWidth polytope_width(const Polytope& p, const Context& context) {
  PolytopeWidth result;
  const auto add_face = [](std::vector<std::uint32_t>& face, std::uint32_t v) {
    if (std::find(face.begin(), face.end(), v) == face.end()) face.push_back(v);
  };
  if (p.dimension() < 3) {
    result.direction = as_point([&] {
      const EdgeVector u = p.edge(p.first_halfedge(0));
      const EdgeVector w = p.edge(p.halfedges()[p.first_halfedge(0)].next);
      const auto vector = [](const EdgeVector& v) { return as_vector(exact_point(v.to) - exact_point(v.from)); };
      return closest::cross(vector(u), vector(w));
    }());
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
  const auto vector = [&]<class Number>(const std::array<std::uint32_t, 2>& pair, Number /*type*/) {
    const Point3& a = p.vertex(pair[0]);
    const Point3& b = p.vertex(pair[1]);
    return closest::Vector<Number>{Number(a.x) - Number(b.x), Number(a.y) - Number(b.y), Number(a.z) - Number(b.z)};
  };
  std::vector<Interval> lengths;
  double reach = 0;
  for (const auto& pair : pairs) {
    const auto d = vector(pair, Interval());
    lengths.push_back(closest::dot(d, d));
    reach = std::max(reach, lengths.back().lower());
  }
  PolytopeDiameter result;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (lengths[i].upper() < reach) continue;
    const auto d = vector(pairs[i], Rational());
    Rational length = closest::dot(d, d);
    if (length <= result.squared_diameter) continue;
    result.squared_diameter = std::move(length);
    result.vertices = pairs[i];
  }
  return result;
}

}  // namespace quoin
