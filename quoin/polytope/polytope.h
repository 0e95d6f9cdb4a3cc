// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/constructions.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/polytope_shape.h"

namespace quoin {

/// A convex polytope of any dimension from 0 to 3: a point, a segment, a flat polygon or a solid, with vertices that
/// are doubles or rationals. Copies share what is rational.
class Polytope : public PolytopeShape {
 public:
  /// The hull of the points. Exact. @throws InputError without points or naming one that is not finite, Cancelled
  static Polytope hull_of(std::span<const Point3> points, const Context& context);
  /// Where all coordinates are doubles, as fast as of these. @throws InputError without points or naming one that
  /// rounds to no finite double, Cancelled
  static Polytope hull_of(std::span<const RationalPoint3> points, const Context& context);
  /// Of points of a table, given or constructed. @throws as that of rationals
  static Polytope hull_of(const Constructions& table, std::span<const PointId> points, const Context& context);

  /// Rounded, where it is no double.
  const Point3& vertex(std::uint32_t v) const { return vertices_ ? vertices_->rounded[v] : points_[v]; }
  RationalPoint3 exact_vertex(std::uint32_t v) const {
    return vertices_ ? vertices_->exact[v] : exact_point(points_[v]);
  }
  /// Some vertex is no double, so edges are rationals.
  bool is_rational() const { return vertices_ != nullptr; }
  /// Index of a vertex among the points given.
  std::uint32_t source(std::uint32_t v) const { return sources_[v]; }

  /// All points -p for p of the polytope: vertices and facets keep their numbers. O(n), exact, no new hull.
  friend Polytope reflected(const Polytope& p);

 private:
  struct RationalVertices {
    std::vector<RationalPoint3> exact;
    std::vector<Point3> rounded;
  };
  static Polytope of_hull(const ConvexHull& hull);
  void set_vertices(std::vector<RationalPoint3> exact, const Context& context);

  std::vector<std::uint32_t> sources_;
  std::shared_ptr<const RationalVertices> vertices_;            // null if all are doubles
  std::shared_ptr<const std::vector<RationalPoint3>> vectors_;  // that edges point to
};

Polytope reflected(const Polytope& p);

}  // namespace quoin
