// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/query/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quoin::closest {

namespace {

constexpr double u = 0x1p-53;
constexpr double spare = 1 + 0x1p-40;

double largest(const Triangle<double>& t) {
  double size = 0;
  for (const Vector<double>& p : t) {
    for (const double x : p) size = std::max(size, std::fabs(x));
  }
  return size;
}

/// The triangles lie on both sides of a gap between two planes normal to w, if it is above zero. Each dot product errs
/// by the coordinates' error and three roundings of at most |w| times the largest coordinate; then a difference.
double gap_along(const Vector<double>& w, const Triangle<double>& a, const Triangle<double>& b, double size,
                 double error) {
  const double length = std::fabs(w[0]) + std::fabs(w[1]) + std::fabs(w[2]);
  if (!(0x1p-400 < length && length < 0x1p400)) return 0;
  const auto range = [&](const Triangle<double>& t) {
    const std::array<double, 3> along{dot(w, t[0]), dot(w, t[1]), dot(w, t[2])};
    return std::minmax({along[0], along[1], along[2]});
  };
  const auto [a_low, a_high] = range(a);
  const auto [b_low, b_high] = range(b);
  const double gap = std::max(a_low - b_high, b_low - a_high) - spare * length * (2 * error + 8 * u * size);
  return gap > 0 ? gap / (std::sqrt(dot(w, w)) * spare) : 0;
}

}  // namespace

/// Upwards: the distance of two points that are means of corners with weights of at least zero, which sum to one but
/// for 4 u. Downwards: a gap between planes, along the line through these points or normal to their features. All that
/// is measured from a corner.
SquaredBounds squared_bounds(const Triangle<double>& a, const Triangle<double>& b, double coordinate_error) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Vector<double> origin = b[0];
  const auto from_origin = [&](const Triangle<double>& t) {
    return Triangle<double>{difference(t[0], origin), difference(t[1], origin), difference(t[2], origin)};
  };
  const Triangle<double> p = from_origin(a);
  const Triangle<double> q = from_origin(b);
  const double size = std::max(largest(p), largest(q));
  if (!(0x1p-200 < size && size < 0x1p200)) return {0, infinite};
  const double error = u * size + 2 * coordinate_error * spare;  // of a corner from the origin
  const PointPair<double> nearest = TrianglePair<double>(p, q).nearest();
  if (!(nearest.squared_length < 0x1p420)) return {0, infinite};  // or not a number, of a sliver
  const Vector<double> between = difference(nearest.points[0], nearest.points[1]);
  const double gap = std::max(gap_along(between, p, q, size, error), gap_along(nearest.normal, p, q, size, error));
  const double distance = std::sqrt(nearest.squared_length) * spare + 4 * error + 64 * u * size;
  return {gap * gap / spare, distance * distance * spare};
}

}  // namespace quoin::closest
