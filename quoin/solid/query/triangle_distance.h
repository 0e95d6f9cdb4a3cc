// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "quoin/kernel/closest_point.h"

/// The points of two triangles that are closest to each other, in doubles (roughly) or rationals (exactly).
namespace quoin::closest {

template <class Number>
using Triangle = std::array<Vector<Number>, 3>;

template <class Number>
Vector<Number> moved(const Vector<Number>& p, const Vector<Number>& along, const Number& by) {
  return {p[0] + along[0] * by, p[1] + along[1] * by, p[2] + along[2] * by};
}

template <class Number>
struct PointPair {
  std::array<Vector<Number>, 2> points;  ///< of the first triangle and of the second
  Number squared_length;
  Vector<Number> normal;  ///< to the triangle or the two edges that they are on
};

/// Nearest points of triangles that have no common point; if they have one, use `common_point` first.
///
/// They are a vertex and the point of the other triangle that is closest to it, or inner points of two edges.
template <class Number>
class TrianglePair {
 public:
  TrianglePair(const Triangle<Number>& a, const Triangle<Number>& b) : triangles_{a, b} {
    for (std::size_t k = 0; k < 2; ++k) {
      const Triangle<Number>& t = triangles_[k];
      for (std::size_t i = 0; i < 3; ++i) edges_[k][i] = difference(t[(i + 1) % 3], t[i]);
      normals_[k] = cross(edges_[k][0], edges_[k][1]);
    }
  }

  PointPair<Number> nearest() {
    for (std::size_t k = 0; k < 2; ++k) {
      for (std::size_t i = 0; i < 3; ++i) consider_vertex(k, i);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) consider_edges(i, j);
    }
    return *best_;
  }

  struct CommonPoint {
    Vector<Number> point;
    bool is_crossing = false;  ///< it is inside a triangle, not on its rim
  };

  /// A common point, if one has an edge with its ends on both sides of the other's plane that meets it; one that
  /// crosses it, if there is any. Those that meet in another way have a vertex in the other, or edges that cross:
  /// nearest points are equal.
  std::optional<CommonPoint> common_point() const {
    const Number zero(0.0);
    std::optional<CommonPoint> result;
    for (std::size_t k = 0; k < 2; ++k) {
      const Triangle<Number>& edges = triangles_[k];
      const Triangle<Number>& t = triangles_[1 - k];
      std::array<Number, 3> heights;
      for (std::size_t i = 0; i < 3; ++i) heights[i] = dot(normals_[1 - k], difference(edges[i], t[0]));
      for (std::size_t i = 0; i < 3; ++i) {
        const Number& from = heights[i];
        const Number& to = heights[(i + 1) % 3];
        if (!((from < zero && zero < to) || (to < zero && zero < from))) continue;
        const Vector<Number> p = moved<Number>(edges[i], edges_[k][i], from / (from - to));
        const int place = place_in(1 - k, p);
        if (place > 0) return CommonPoint{p, true};
        if (place == 0) result = CommonPoint{p};
      }
    }
    return result;
  }

 private:
  /// Of a point of its plane: 1 inside, 0 on the rim, -1 outside.
  int place_in(std::size_t k, const Vector<Number>& p) const {
    const Number zero(0.0);
    int place = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const Number area = dot(normals_[k], cross(edges_[k][i], difference(p, triangles_[k][i])));
      if (area < zero) return -1;
      if (!(zero < area)) place = 0;
    }
    return place;
  }

  void consider(std::size_t k, const Vector<Number>& of_k, const Vector<Number>& of_other,
                const Vector<Number>& normal) {
    const Vector<Number> between = difference(of_k, of_other);
    const Number length = dot(between, between);
    if (best_ && !(length < best_->squared_length)) return;
    best_ = PointPair<Number>{
        k == 0 ? std::array<Vector<Number>, 2>{of_k, of_other} : std::array<Vector<Number>, 2>{of_other, of_k}, length,
        normal};
  }

  /// Vertex i of triangle k and the other triangle.
  void consider_vertex(std::size_t k, std::size_t i) {
    const Vector<Number>& vertex = triangles_[k][i];
    const Triangle<Number>& t = triangles_[1 - k];
    const Triangle<Number> from_vertex{difference(t[0], vertex), difference(t[1], vertex), difference(t[2], vertex)};
    const ClosestPoint<Number> closest =
        on_polygon<Number>(std::span<const Vector<Number>>(from_vertex), normals_[1 - k]);
    Vector<Number> p{Number(0.0), Number(0.0), Number(0.0)};
    for (std::size_t j = 0; j < 3; ++j) p = moved<Number>(p, t[closest.corners[j]], closest.weights[j]);
    consider(k, vertex, p, normals_[1 - k]);
  }

  /// Inner points of both edges on the line that is normal to both.
  void consider_edges(std::size_t i, std::size_t j) {
    const Number zero(0.0);
    const Number one(1.0);
    const Vector<Number>& u = edges_[0][i];
    const Vector<Number>& v = edges_[1][j];
    const Vector<Number> between = difference(triangles_[0][i], triangles_[1][j]);
    const Number uu = dot(u, u);
    const Number uv = dot(u, v);
    const Number vv = dot(v, v);
    const Number size = uu * vv - uv * uv;
    if (!(zero < size)) return;
    const Number ub = dot(u, between);
    const Number vb = dot(v, between);
    const Number s = (uv * vb - vv * ub) / size;
    const Number t = (uu * vb - uv * ub) / size;
    if (!(zero < s && s < one && zero < t && t < one)) return;
    consider(0, moved<Number>(triangles_[0][i], u, s), moved<Number>(triangles_[1][j], v, t), cross(u, v));
  }

  std::array<Triangle<Number>, 2> triangles_;
  std::array<Triangle<Number>, 2> edges_;
  std::array<Vector<Number>, 2> normals_;
  std::optional<PointPair<Number>> best_;
};

/// Doubles that enclose the square of the distance of two triangles whose coordinates are off by no more than an error.
struct SquaredBounds {
  double lower = 0;
  double upper = 0;
};
SquaredBounds squared_bounds(const Triangle<double>& a, const Triangle<double>& b, double coordinate_error);

}  // namespace quoin::closest
