// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

/// The point of a convex polygon that is closest to the origin, in doubles (roughly) or rationals (exactly).
namespace quoin::closest {

template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
Vector<Number> difference(const Vector<Number>& a, const Vector<Number>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A point as the mean of at most three corners of a polygon with weights that sum to one.
template <class Number>
struct ClosestPoint {
  Vector<Number> point;
  Number squared_length;
  std::array<std::size_t, 3> corners;
  Vector<Number> weights;
};

template <class Number>
ClosestPoint<Number> on_edge(std::span<const Vector<Number>> polygon, std::size_t i) {
  const std::size_t k = i + 1 < polygon.size() ? i + 1 : 0;
  const Vector<Number> along = difference(polygon[k], polygon[i]);
  const Number zero(0.0);
  const Number one(1.0);
  Number t = -dot(polygon[i], along) / dot(along, along);
  if (t < zero) t = zero;
  if (one < t) t = one;
  const Vector<Number> p{polygon[i][0] + along[0] * t, polygon[i][1] + along[1] * t, polygon[i][2] + along[2] * t};
  return {p, dot(p, p), {i, k, i}, {one - t, t, zero}};
}

/// `normal` is any normal about which the corners run counterclockwise; at least three corners, strictly convex.
template <class Number>
ClosestPoint<Number> on_polygon(std::span<const Vector<Number>> polygon, const Vector<Number>& normal) {
  const Number zero(0.0);
  const Number scale = dot(normal, polygon[0]) / dot(normal, normal);
  const Vector<Number> foot{normal[0] * scale, normal[1] * scale, normal[2] * scale};
  // Twice the area, times the normal's length, of the triangle from an edge to the foot.
  const auto area = [&](std::size_t i, std::size_t k) {
    return dot(normal, cross(difference(polygon[i], foot), difference(polygon[k], foot)));
  };
  bool is_inside = true;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    is_inside = is_inside && !(area(i, i + 1 < polygon.size() ? i + 1 : 0) < zero);
  }
  for (std::size_t i = 1; is_inside && i + 1 < polygon.size(); ++i) {
    const Vector<Number> weights{area(i, i + 1), area(i + 1, 0), area(0, i)};
    if (weights[0] < zero || weights[1] < zero || weights[2] < zero) continue;
    const Number sum = weights[0] + weights[1] + weights[2];
    return {foot, dot(foot, foot), {0, i, i + 1}, {weights[0] / sum, weights[1] / sum, weights[2] / sum}};
  }
  ClosestPoint<Number> best = on_edge(polygon, 0);
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    const ClosestPoint<Number> other = on_edge(polygon, i);
    if (other.squared_length < best.squared_length) best = other;
  }
  return best;
}

}  // namespace quoin::closest
