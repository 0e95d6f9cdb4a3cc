// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull_simplex.h"

#include <algorithm>
#include <cmath>

#include "quoin/base/sign.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/kernel/predicates3.h"

namespace quoin {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

Point2 project(const Point3& p, unsigned axis) {
  return axis == 0 ? Point2{p.y, p.z} : axis == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
}

bool collinear(const Point3& a, const Point3& b, const Point3& c) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (orientation(project(a, axis), project(b, axis), project(c, axis)) != Sign::zero) return false;
  }
  return true;
}

/// Differences of halves, over the largest of them, so that nothing overflows where it is used.
Vector3 direction(const Point3& a, const Point3& b) {
  Vector3 d{b.x / 2 - a.x / 2, b.y / 2 - a.y / 2, b.z / 2 - a.z / 2};
  const double size = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  if (size > 0) d = {d.x / size, d.y / size, d.z / size};
  return d;
}
Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The point of the largest measure, if it fits; else the first that does.
template <class Measure, class Fits>
std::uint32_t best_point(std::size_t count, const Context& context, const Measure& measure, const Fits& fits) {
  std::uint32_t best = 0;
  double most = -1;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i % 16384 == 0) context.poll();
    const double value = measure(i);
    if (value > most) {
      most = value;
      best = i;
    }
  }
  if (fits(best)) return best;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i % 1024 == 0) context.poll();
    if (fits(i)) return i;
  }
  return none;
}

/// `points` may be rounded: they suggest what is far, and `signs` decide.
template <class Signs>
Simplex find_simplex_by(std::span<const Point3> points, const Signs& signs, const Context& context) {
  Simplex result;
  if (points.empty()) return result;
  std::uint32_t least = 0;
  std::uint32_t largest = 0;
  for (std::uint32_t i = 1; i < points.size(); ++i) {
    if (i % 256 == 0) context.poll();
    if (signs.is_less(i, least)) least = i;
    if (signs.is_less(largest, i)) largest = i;
  }
  result.points[result.count++] = least;
  if (!signs.is_less(least, largest)) return result;
  result.points[result.count++] = largest;
  const Point3& a = points[least];
  const Vector3 along = direction(a, points[largest]);
  const std::uint32_t third = best_point(
      points.size(), context,
      [&](std::uint32_t i) {
        const Point3& p = points[i];
        const Vector3 n = cross(along, {p.x / 2 - a.x / 2, p.y / 2 - a.y / 2, p.z / 2 - a.z / 2});
        return std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z);
      },
      [&](std::uint32_t i) { return !signs.are_collinear(least, largest, i); });
  if (third == none) return result;
  result.points[result.count++] = third;
  const Vector3 normal = cross(along, direction(a, points[third]));
  const std::uint32_t fourth = best_point(
      points.size(), context,
      [&](std::uint32_t i) {
        const Point3& p = points[i];
        return std::fabs(normal.x * (p.x / 2 - a.x / 2) + normal.y * (p.y / 2 - a.y / 2) +
                         normal.z * (p.z / 2 - a.z / 2));
      },
      [&](std::uint32_t i) { return !signs.are_coplanar(least, largest, third, i); });
  if (fourth == none) return result;
  result.points[result.count++] = fourth;
  return result;
}

struct SignsOfDoubles {
  std::span<const Point3> points;
  bool is_less(std::uint32_t i, std::uint32_t k) const { return lexicographically_less(points[i], points[k]); }
  bool are_collinear(std::uint32_t i, std::uint32_t k, std::uint32_t l) const {
    return collinear(points[i], points[k], points[l]);
  }
  bool are_coplanar(std::uint32_t i, std::uint32_t k, std::uint32_t l, std::uint32_t m) const {
    return orientation(points[i], points[k], points[l], points[m]) == Sign::zero;
  }
};

struct SignsOfTable {
  const Constructions& table;
  std::span<const PointId> ids;
  bool is_less(std::uint32_t i, std::uint32_t k) const {
    return table.compare_lexicographically(ids[i], ids[k]) == Sign::negative;
  }
  bool are_collinear(std::uint32_t i, std::uint32_t k, std::uint32_t l) const {
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (table.turn_any(ids[i], ids[k], ids[l], axis) != Sign::zero) return false;
    }
    return true;
  }
  bool are_coplanar(std::uint32_t i, std::uint32_t k, std::uint32_t l, std::uint32_t m) const {
    return table.orientation_any(ids[i], ids[k], ids[l], ids[m]) == Sign::zero;
  }
};

}  // namespace

unsigned axis_to_drop(const Point3& a, const Point3& b, const Point3& c) {
  for (unsigned axis = 0; axis < 2; ++axis) {
    if (orientation(project(a, axis), project(b, axis), project(c, axis)) != Sign::zero) return axis;
  }
  return 2;
}

Simplex find_simplex(std::span<const Point3> points, const Context& context) {
  return find_simplex_by(points, SignsOfDoubles{points}, context);
}

Simplex find_simplex(std::span<const Point3> rounded, const Constructions& table, std::span<const PointId> ids,
                     const Context& context) {
  return find_simplex_by(rounded, SignsOfTable{table, ids}, context);
}

std::vector<std::uint32_t> extremes(std::span<const Point3> points, const Context& context) {
  // Half of the directions with components -1, 0 and 1.
  constexpr std::array<std::array<int, 3>, 13> directions{{{1, 0, 0},
                                                           {0, 1, 0},
                                                           {0, 0, 1},
                                                           {1, 1, 0},
                                                           {1, -1, 0},
                                                           {1, 0, 1},
                                                           {1, 0, -1},
                                                           {0, 1, 1},
                                                           {0, 1, -1},
                                                           {1, 1, 1},
                                                           {1, 1, -1},
                                                           {1, -1, 1},
                                                           {1, -1, -1}}};
  std::array<double, 13> low;
  std::array<double, 13> high;
  std::array<std::uint32_t, 13> lowest{};
  std::array<std::uint32_t, 13> highest{};
  const std::size_t step = points.size() / 65536 + 1;
  context.poll();
  for (std::size_t at = 0; at < points.size(); at += step) {
    const auto i = static_cast<std::uint32_t>(at);
    const Point3& p = points[i];
    for (std::size_t d = 0; d < directions.size(); ++d) {
      const double height = directions[d][0] * (p.x / 4) + directions[d][1] * (p.y / 4) + directions[d][2] * (p.z / 4);
      if (i == 0 || height < low[d]) {
        low[d] = height;
        lowest[d] = i;
      }
      if (i == 0 || height > high[d]) {
        high[d] = height;
        highest[d] = i;
      }
    }
  }
  std::vector<std::uint32_t> result(lowest.begin(), lowest.end());
  result.insert(result.end(), highest.begin(), highest.end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace quoin
