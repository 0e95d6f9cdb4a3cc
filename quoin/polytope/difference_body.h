// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/closest_point.h"
#include "quoin/number/interval.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/polytope.h"

namespace quoin {

/// All differences of a point of A and a point of B, and where the origin is to its facets.
class DifferenceBody {
 public:
  using Exact = closest::Vector<Rational>;
  using Rounded = closest::Vector<double>;

  DifferenceBody(const Polytope& a, const Polytope& b, const Context& context)
      : a_(a), b_(reflected(b)), sum_(minkowski_sum(a_, b_, context)) {
    if (a_.is_rational() || b_.is_rational()) exact_ = exact_vertices(sum_, a_, b_);
  }

  int dimension() const { return sum_.dimension; }
  std::size_t facet_count() const { return sum_.facet_count(); }
  std::size_t vertex_count() const { return sum_.vertices.size(); }
  std::span<const std::uint32_t> facet(std::size_t f) const { return sum_.facet(f); }
  /// Vertices of the two polytopes that a vertex is the difference of: a reflected polytope keeps their numbers.
  const std::array<std::uint32_t, 2>& sources(std::uint32_t v) const { return sum_.vertices[v]; }
  RationalPoint3 point_of_a(std::uint32_t v) const { return a_.exact_vertex(sources(v)[0]); }
  RationalPoint3 point_of_b(std::uint32_t v) const { return b_.exact_vertex(sources(v)[1]) * Rational(-1); }

  /// Positive: the origin is inside of the facet's plane.
  Sign depth_sign(std::size_t f) const {
    const auto corners = facet(f);
    const std::array<EdgeVector, 3> v{vector(corners[0]), vector(corners[1]), vector(corners[2])};
    return determinant(rounded(v[0]), rounded(v[1]), rounded(v[2]),
                       [&] { return exact_determinant(v[0], v[1], v[2]); });
  }

  Exact exact(std::uint32_t v) const {
    const RationalPoint3 d = point_of_a(v) - point_of_b(v);
    return {d.x, d.y, d.z};
  }
  Rounded approximate(std::uint32_t v) const {
    const Vector3 d = rounded(vector(v));
    return {d.x, d.y, d.z};
  }
  closest::Vector<Interval> enclosed(std::uint32_t v) const {
    if (!exact_.empty()) {
      return {Interval::around(exact_[v].x), Interval::around(exact_[v].y), Interval::around(exact_[v].z)};
    }
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
  /// Of a body that is no solid.
  closest::ClosestPoint<Rational> exact_closest() const {
    if (dimension() == 2) return exact_closest(0);
    const std::uint32_t last = dimension() == 1 ? 1 : 0;
    const std::array<Exact, 2> ends{exact(0), exact(last)};
    if (last == 1) return closest::on_edge<Rational>(ends, 0);
    return {ends[0], closest::dot(ends[0], ends[0]), {0, 0, 0}, {Rational(1), Rational(0), Rational(0)}};
  }
  closest::ClosestPoint<Rational> exact_closest(std::size_t f) const {
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
    if (!exact_.empty()) return edge_vector(exact_[v]);
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
  std::vector<RationalPoint3> exact_;     // the vertices, if they are no sums of doubles
  mutable std::vector<Rounded> polygon_;  // scratch
};

}  // namespace quoin
