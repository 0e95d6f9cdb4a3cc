// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/solid/float_box.h"

namespace quoin {

/// Differences and products of a tile's corners in doubles, for decisions that may be left open.
///
/// With u = 2^-53, edges e0, e1, e2 along the tile's boundary, and A, B the largest components of e0 and e2: a
/// component of the normal e0 x -e2 is a difference of products below A B with roundings of 2 differences and a product
/// each, and its own, so it is off by 2 * 3 u A B + 2 u A B = 8 u A B. Its product with a component of a vector d,
/// which itself may be off by u of its largest component D, is off by 8 u A B D + 2 u A B (1 + 1) D; three of them and
/// their two sums (below 4 and 6 A B D) by 36 + 4 + 6 = 46 u A B D < 2^-47 A B D. That holds as long as nothing
/// underflows, which sizes of products of two and of three above 1e-250 exclude; an infinite size decides nothing.
struct TileEdges {
  static constexpr double relative_bound = 0x1p-47;
  static constexpr double smallest_safe = 1e-250;

  std::array<Vector3, 3> edge;  ///< from corner k to k + 1
  std::array<double, 3> size;   ///< largest components
  Vector3 normal;

  TileEdges(const std::vector<Point3>& vertices, const Tile& tile) {
    for (std::size_t k = 0; k < 3; ++k) {
      edge[k] = difference(vertices[tile[(k + 1) % 3]], vertices[tile[k]]);
      size[k] = largest(edge[k]);
    }
    const Vector3& a = edge[0];
    const Vector3& b = edge[2];
    normal = {a.z * b.y - a.y * b.z, a.x * b.z - a.z * b.x, a.y * b.x - a.x * b.y};
  }

  double normal_size() const { return size[0] * size[2]; }

  static Vector3 difference(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  static double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  static double largest(const Vector3& v) { return std::max(std::max(std::fabs(v.x), std::fabs(v.y)), std::fabs(v.z)); }

  /// Whether the sign of a value with such a bound, relative to a product of sizes, is certain.
  static bool is_certain(double value, double size) {
    return (size > smallest_safe) & (std::fabs(value) > relative_bound * size);
  }
  /// The same of the product of the normal with a vector of this size.
  bool is_certain_along(double value, double vector_size) const {
    return (normal_size() > smallest_safe) & is_certain(value, normal_size() * vector_size);
  }
};

}  // namespace quoin
