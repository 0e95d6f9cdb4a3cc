// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "quoin/kernel/point.h"
#include "quoin/kernel/predicate_filters.h"
#include "quoin/triangulation/cell_array.h"

namespace quoin {

/// What is known of all points of a triangulation together: bounds for filters that cost one comparison, and the grid
/// on which doubles do not round.
struct PointExtent {
  double x = 0;  ///< largest difference of coordinates, up to a rounding
  double y = 0;
  double z = 0;
  double largest = 0;  ///< magnitude of a coordinate
  double grid = 0;     ///< a power of two of which all coordinates are multiples; 0 if there is none above 2^-200

  PointExtent() = default;
  explicit PointExtent(std::span<const Point3> points);
};

/// The extent of points that come one after the other.
class GrowingExtent {
 public:
  void add(const Point3& p);
  /// Of one point at least.
  PointExtent extent() const;

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::array<double, 3> low_{infinity, infinity, infinity};
  std::array<double, 3> high_{-infinity, -infinity, -infinity};
  int lowest_bit_ = 2000;
};

/// The predicates of a Delaunay triangulation of given points, by the indices of the points.
///
/// Exact for all points. The tiers: a bound for all points; the bound of filter::in_sphere for the call; where the
/// values of the call are small multiples of the grid, the double itself, which is then exact; integers.
///
/// Points of one sphere are told apart as if each were lifted by an infinitely small height above the paraboloid, those
/// that are larger in lexicographic order infinitely higher: so each triangulation is unique, whatever the order of
/// insertion, and no cell is flat. Source: Devillers and Teillaud 2011.
class DelaunaySigns {
 public:
  static constexpr bool may_hide = false;

  /// Of no points.
  DelaunaySigns() : DelaunaySigns({}, PointExtent(), no_vertex) {}
  /// If the points lie in one plane but for the last, `is_flat`: then four of the others are coplanar without a test.
  DelaunaySigns(std::span<const Point3> points, bool is_flat);
  /// Of points within an extent, some of which may be none of the triangulation and lie anywhere. If those that are lie
  /// in one plane but for one, this is the `apex`; else it is no_vertex.
  DelaunaySigns(std::span<const Point3> points, const PointExtent& extent, std::uint32_t apex);

  int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    const filter::Orientation det(points_[a], points_[b], points_[c], points_[d]);
    if (std::fabs(det.value) > orientation_bound_) [[likely]]
      return det.value > 0 ? 1 : -1;
    return close_orientation(a, b, c, d, det.value);
  }

  /// Whether q is inside the sphere of the cell, which is none at infinity.
  bool in_conflict(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t q) const {
    const filter::InSphere det(points_[a], points_[b], points_[c], points_[d], points_[q]);
    if (std::fabs(det.value) > sphere_bound_) [[likely]]
      return det.value > 0;
    return close_conflict(a, b, c, d, q, det.value);
  }

  /// Sign of the sphere test without perturbation; positive inside.
  int in_sphere(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t q) const;

 private:
  int close_orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, double value) const;
  bool close_conflict(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t q,
                      double value) const;
  int close_sphere(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t q,
                   double value) const;
  void choose_keys(const PointExtent& extent);

  const Point3* points_;
  std::uint32_t apex_;  ///< the only point off the plane of all others, or no_vertex
  double orientation_bound_;
  double sphere_bound_;
  bool is_orientation_exact_ = false;  ///< the doubles do not round, for any points
  bool is_sphere_exact_ = false;
  double orientation_grid_ = 0;  ///< products of maxima below it do not round
  double sphere_grid_ = 0;
  // Where coordinates are small multiples of the grid, x key_x_ + y key_y_ + z is exact and in lexicographic order.
  bool has_keys_ = false;
  double key_x_ = 0;
  double key_y_ = 0;
  double integer_scale_ = 0;  ///< makes coordinates integers below 2^61, where they are such
  double integer_unit_ = 0;   ///< its inverse
};

/// The perturbation: whether q is in conflict with the cell whose sphere it lies on. `is_less(i, j)` is the
/// lexicographic order of a, b, c, d, q by their places 0 to 4; `orientation_sign` is exact, of points given by their
/// numbers.
template <class Less, class OrientationSign>
bool is_perturbed_inside(const std::array<std::uint32_t, 5>& v, const Less& is_less,
                         const OrientationSign& orientation_sign) {
  // Without branches, which would surprise the processor half of the time.
  std::array<unsigned, 5> lower{};  // how many are lifted more
  for (unsigned i = 0; i < 5; ++i) {
    for (unsigned j = i + 1; j < 5; ++j) {
      const bool is_lower = is_less(i, j);
      lower[i] += is_lower ? 1 : 0;
      lower[j] += is_lower ? 0 : 1;
    }
  }
  std::array<unsigned, 5> by_height{};
  for (unsigned i = 0; i < 5; ++i) by_height[lower[i]] = i;
  for (const unsigned highest : by_height) {
    // Where q is lifted more than all that are left, it leaves the sphere.
    if (highest == 4) return false;
    std::array<std::uint32_t, 4> replaced{v[0], v[1], v[2], v[3]};
    replaced[highest] = v[4];
    const int weight = orientation_sign(replaced[0], replaced[1], replaced[2], replaced[3]);
    if (weight != 0) return weight > 0;
  }
  return false;
}

}  // namespace quoin
