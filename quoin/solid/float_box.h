// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "quoin/kernel/point.h"

namespace quoin {

/// A triangle of a leaf mesh as three vertex indices.
using Tile = std::array<std::uint32_t, 3>;

/// A closed box of floats around something exact; `Box3` of the kernel is the exact one.
struct FloatBox {
  std::array<float, 3> lo;
  std::array<float, 3> hi;
};

/// Contains nothing and meets nothing.
constexpr FloatBox empty_box() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

inline void extend(FloatBox& box, const FloatBox& other) {
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = std::min(box.lo[k], other.lo[k]);
    box.hi[k] = std::max(box.hi[k], other.hi[k]);
  }
}

inline bool meet(const FloatBox& a, const FloatBox& b) {
  return a.lo[0] <= b.hi[0] && b.lo[0] <= a.hi[0] && a.lo[1] <= b.hi[1] && b.lo[1] <= a.hi[1] && a.lo[2] <= b.hi[2] &&
         b.lo[2] <= a.hi[2];
}

/// At most x, and within 2^-22 |x| + 2^-148 of it while that is a float. Moving by 2^-23 |x| + 2^-149 outdoes the
/// rounding to float, which is at most 2^-24 |x| or 2^-150; above the largest float the result is that float.
inline float float_below(double x) {
  return std::min(static_cast<float>(x - (std::fabs(x) * 0x1p-23 + 0x1p-149)), std::numeric_limits<float>::max());
}

/// At least x; mirrors `float_below`.
inline float float_above(double x) {
  return -float_below(-x);
}

inline FloatBox box_of(std::span<const Point3> vertices, const Tile& tile) {
  const Point3& p = vertices[tile[0]];
  const Point3& q = vertices[tile[1]];
  const Point3& r = vertices[tile[2]];
  return {{float_below(std::min(std::min(p.x, q.x), r.x)), float_below(std::min(std::min(p.y, q.y), r.y)),
           float_below(std::min(std::min(p.z, q.z), r.z))},
          {float_above(std::max(std::max(p.x, q.x), r.x)), float_above(std::max(std::max(p.y, q.y), r.y)),
           float_above(std::max(std::max(p.z, q.z), r.z))}};
}

/// Around one point; also around any exact point whose coordinates round to these doubles.
inline FloatBox box_of(const Point3& p) {
  return {{float_below(p.x), float_below(p.y), float_below(p.z)},
          {float_above(p.x), float_above(p.y), float_above(p.z)}};
}

/// Four boxes side by side, coordinate by coordinate.
struct BoxBlock {
  using Floats = float __attribute__((vector_size(16)));
  using Mask = std::int32_t __attribute__((vector_size(16)));  // -1 or 0 per lane

  std::array<Floats, 3> lo;
  std::array<Floats, 3> hi;

  /// Lanes of NaN, which meet nothing, not even a box without bounds.
  static BoxBlock empty() {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const Floats none = {nan, nan, nan, nan};
    return {{none, none, none}, {none, none, none}};
  }
  void set(std::size_t lane, const FloatBox& box) {
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k][lane] = box.lo[k];
      hi[k][lane] = box.hi[k];
    }
  }
  FloatBox at(std::size_t lane) const {
    return {{lo[0][lane], lo[1][lane], lo[2][lane]}, {hi[0][lane], hi[1][lane], hi[2][lane]}};
  }
  Mask meets(const FloatBox& box) const {
    return (lo[0] <= box.hi[0]) & (hi[0] >= box.lo[0]) & (lo[1] <= box.hi[1]) & (hi[1] >= box.lo[1]) &
           (lo[2] <= box.hi[2]) & (hi[2] >= box.lo[2]);
  }
};

inline bool is_any(const BoxBlock::Mask& mask) {
  using Halves = std::int64_t __attribute__((vector_size(16)));
  const auto halves = reinterpret_cast<Halves>(mask);
  return (halves[0] | halves[1]) != 0;
}

}  // namespace quoin
