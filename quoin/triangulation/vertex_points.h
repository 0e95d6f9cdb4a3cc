// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/large_vector.h"
#include "quoin/kernel/point.h"

namespace quoin {

enum class Scaling {
  none,
  allowed  ///< by a power of two that brings points into the range of the filters, if no coordinate is rounded
};

/// The distinct points of a list, along a Hilbert curve whatever the order of the list.
struct VertexPoints {
  /// A vertex that is several points; up to it there are `surplus` more points than vertices.
  struct Repeated {
    std::uint32_t vertex;
    std::uint32_t surplus;
  };

  LargeVector<Point3> points;         ///< times a power of two; no zero is negative
  double unscale = 1;                 ///< gives them back
  std::vector<std::uint32_t> inputs;  ///< numbers in the list, of each vertex ascending
  std::vector<Repeated> repeated;     ///< ascending by vertex

  /// @throws InputError without points, with more than 150,000,000, or naming one that is not finite; Cancelled
  VertexPoints(std::span<const Point3> list, Scaling scaling, const Context& context);

  /// Logarithmic in the number of vertices that are several points.
  std::span<const std::uint32_t> inputs_of(std::uint32_t vertex) const;
  Point3 original(std::uint32_t vertex) const {
    const Point3& p = points[vertex];
    return {p.x * unscale, p.y * unscale, p.z * unscale};
  }
  std::span<const Point3> all() const { return {points.data(), points.size()}; }
};

/// The power of two that brings coordinates into the range of the filters, given the largest magnitude of one; 1 where
/// none does, or none need.
double filter_scale(double largest);
/// Whether no coordinate times a power of two is rounded.
bool scales_exactly(const Point3& p, double scale);

/// Names the number of points and the memory that they need.
[[noreturn]] void refuse_for_memory(std::size_t points);

}  // namespace quoin
