// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/id.h"
#include "quoin/base/sign.h"
#include "quoin/kernel/constructions_counts.h"
#include "quoin/kernel/constructions_filters.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/kernel/tier.h"
#include "quoin/number/integer.h"

namespace quoin {

using PointId = Id<struct PointTag>;
using PlaneId = Id<struct PlaneTag>;
using LineId = Id<struct LineTag>;

/// Widths of the exact tier, by the bits that the coordinates of all explicit points need on their common power-of-two
/// grid.
enum class GridClass { bits30, bits61, bits124, big, rational };

/// Who decided how many predicate calls; summed over threads.
struct TierCounts {
  std::uint64_t filter = 0;
  std::uint64_t exact = 0;
};

/// A table of explicit points and of the planes, lines and points constructed from them, with the exact predicates on
/// them.
///
/// Points [0, explicit_count()) are given; the others are constructed, never from constructed ones: depth stays one.
/// Each construction is computed exactly once, when it is set, in the narrowest fixed-width integers that hold every
/// value of the table's grid class (bounds derived in constructions.cc), and kept with its coordinates rounded to
/// nearest. Predicates try a filter on the rounded values first and fall back to the exact ones; they return the true
/// sign.
///
/// Slots are made by `resize_*` and filled by `set_*`; setting distinct slots from several threads is safe, and so is
/// every const member once the slots it reads are set. A construction whose condition fails (collinear points, parallel
/// planes) throws InternalError. Axes are 0, 1, 2; "projected along axis" means onto the coordinates (axis+1, axis+2)
/// mod 3, so that a positive turn is counterclockwise seen from the positive end of the axis.
class Constructions {
 public:
  /// Explicit points are finite doubles (-0 becomes +0). O(n), one pass to find the grid class.
  /// @throws InputError  names the first point that is not finite
  explicit Constructions(std::vector<Point3> explicit_points);
  /// Explicit points are rationals (solids read from the exact text form, sums of points). Where all coordinates are
  /// sums of two doubles, the nearest one and the rest, they have a grid class as doubles have; else every predicate is
  /// exact rational arithmetic. The same filters go before (with the bound for rounded points where some are rounded).
  /// @throws Cancelled  through the context, if there is one
  explicit Constructions(std::vector<RationalPoint3> explicit_points, const Context* context = nullptr);
  Constructions(const Constructions&) = delete;
  Constructions& operator=(const Constructions&) = delete;
  Constructions(Constructions&&) noexcept;
  Constructions& operator=(Constructions&&) noexcept;
  ~Constructions();

  std::size_t explicit_count() const { return explicit_count_; }
  std::size_t point_count() const { return points_.size(); }
  std::size_t plane_count() const { return planes_.size(); }
  GridClass grid_class() const { return grid_class_; }
  /// Whether the explicit points are doubles, so that their rounded coordinates are exact.
  bool has_explicit_doubles() const { return filter_kind_ != FilterKind::rounded; }

  /// The new slots are unset. New points get ids from point_count() on.
  void resize_points(std::size_t count);
  void resize_planes(std::size_t count);
  void resize_lines(std::size_t count);

  /// Plane through explicit points, normal (b - a) x (c - a), which must not vanish.
  void set_plane(PlaneId plane, PointId a, PointId b, PointId c);
  /// Plane through explicit p, q parallel to the axis; its positive side is to the left of p -> q projected along the
  /// axis. p and q must differ in that projection.
  void set_axis_plane(PlaneId plane, PointId p, PointId q, unsigned axis);

  /// Direction q - p of explicit points.
  void set_line(LineId line, PointId p, PointId q);
  /// Direction normal(p) x normal(q), the planes not parallel.
  void set_line(LineId line, PlaneId p, PlaneId q);

  /// Where the line through explicit p, q meets the plane; not parallel.
  void set_point(PointId point, PointId p, PointId q, PlaneId plane);
  /// Where the lines through explicit p, q and explicit r, s of one plane cross; not parallel. The axis is one along
  /// which their plane's normal has a component (`main_axis`). Without a common plane: the point of the line through p,
  /// q that lies on the other one projected along the axis.
  void set_crossing(PointId point, PointId p, PointId q, PointId r, PointId s, unsigned axis);
  /// Where three planes meet; normals independent.
  void set_point(PointId point, PlaneId p, PlaneId q, PlaneId r);
  /// (wa a + wb b + wc c) / (wa + wb + wc) of explicit points; each weight below 2^20, their sum positive.
  void set_point(PointId point, std::array<PointId, 3> corners, std::array<std::uint32_t, 3> weights);

  /// The coordinates, each rounded to the nearest double, ties to even; exact for explicit double points. A function of
  /// the point's value alone, so equal points have equal rounded coordinates.
  const Point3& rounded(PointId point) const { return points_[point.index()]; }
  RationalPoint3 exact(PointId point) const;
  /// Whether the rounded coordinates are the exact ones.
  bool is_exact(PointId point) const;

  // Predicates on explicit points.
  /// Sign of det(b - a, c - a, d - a).
  Sign orientation(PointId a, PointId b, PointId c, PointId d) const;
  /// Turn a, b, c projected along the axis.
  Sign turn(PointId a, PointId b, PointId c, unsigned axis) const;

  // Predicates on any points.
  /// Positive: on the side the normal points to.
  Sign side(PointId point, PlaneId plane) const;
  /// Sign of p[axis] - q[axis].
  Sign compare(PointId p, PointId q, unsigned axis) const;
  bool equal(PointId p, PointId q) const;
  /// Turn a, b, c projected along the axis; fastest where a and b are explicit.
  Sign turn_any(PointId a, PointId b, PointId c, unsigned axis) const;

  // Predicates on any points, bodies in constructed_predicates.cc: a filter on the rounded coordinates, then integers
  // of any size (microseconds). Explicit points take the tiers of their own. Properties of each, tested: swapping two
  // points negates the sign; it depends on the values of the points alone, not on how they are constructed; it is that
  // of the predicate of the same name on explicit points.
  /// Sign of det(b - a, c - a, d - a). Zero if and only if the points lie in one plane.
  Sign orientation_any(PointId a, PointId b, PointId c, PointId d) const;
  /// Side of the circle through a, b, c on which d lies, all projected along the axis: positive inside if a, b, c turn
  /// counterclockwise. Zero if and only if the projections lie on one circle or line, or two are equal.
  Sign in_circle(PointId a, PointId b, PointId c, PointId d, unsigned axis) const;
  /// Side of the sphere through a, b, c, d on which e lies: positive inside if orientation_any(a, b, c, d) is positive.
  /// Zero if and only if the points lie on one sphere or plane, or four of them on one circle or line, or two are
  /// equal.
  Sign in_sphere(PointId a, PointId b, PointId c, PointId d, PointId e) const;
  /// By x, then y, then z. Negative if p comes first, zero if and only if the points are equal; transitive.
  /// Counted as the comparisons of coordinates that it makes.
  Sign compare_lexicographically(PointId p, PointId q) const;
  /// Along the line's direction: the sign of direction . (p - q). Negative if p comes first, zero if and only if p - q
  /// is normal to the line; transitive.
  Sign compare_along(LineId line, PointId p, PointId q) const;

  // Predicates on planes and lines.
  Sign normal_component(PlaneId plane, unsigned axis) const;
  /// An axis along which the normal has a nonzero component, the one of largest rounded magnitude.
  unsigned main_axis(PlaneId plane) const;
  /// Sign of normal(p) . normal(q).
  Sign dot(PlaneId p, PlaneId q) const;
  Sign component(LineId line, unsigned axis) const;
  /// Sign of the cross product of two directions projected along the axis.
  Sign turn(LineId a, LineId b, unsigned axis) const;
  /// Sign of direction(line) . (normal(p) x normal(q)).
  Sign triple(LineId line, PlaneId p, PlaneId q) const;

  /// Exact coefficients (a, b, c, d) with a x + b y + c z = d, up to a positive factor.
  std::array<Rational, 4> plane_equation(PlaneId plane) const;

  /// A table that holds these points in this order (explicit ones must come first) and no planes or lines.
  Constructions subset(std::span<const PointId> points) const;

  /// Exact while at most 16 threads have ever used tables; beyond, counts of threads that share a counter may get lost.
  TierCounts tier_counts() const;

 private:
  struct Store;  // the table of exact values of the grid class
  enum class FilterKind : std::uint8_t {
    plain,      // explicit coordinates zero or of magnitude within [2^-330, 2^330]: products of three stay normal
    any_range,  // explicit coordinates of any magnitude
    rounded     // doubles of explicit points are rounded
  };

  Constructions();
  bool is_explicit(PointId point) const { return point.index() < explicit_count_; }
  bool has_exact_doubles(PointId point) const { return is_explicit(point) && filter_kind_ != FilterKind::rounded; }
  void set_extent(double largest);
  void set_doubles(std::vector<Point3> points, std::vector<Point3> tails);
  // Counts the decision; 0 is none.
  bool is_decided(int sign) const {
    if (sign == 0) [[unlikely]]
      return false;
    counter_->count_filter();
    return true;
  }
  // Counts the tier.
  Sign counted(Sign sign, Tier tier) const;

  // Coordinates x / w, y / w, z / w in units of the table's grid; w positive.
  std::array<Integer, 4> homogeneous(PointId point) const;
  // Up to a positive factor.
  std::array<Integer, 3> direction(LineId line) const;

  Sign turn_beyond_explicit(PointId a, PointId b, PointId c, unsigned axis) const;
  Sign orientation_beyond_plain(PointId a, PointId b, PointId c, PointId d) const;
  Sign exact_orientation(PointId a, PointId b, PointId c, PointId d) const;
  Sign exact_turn(PointId a, PointId b, PointId c, unsigned axis) const;
  Sign exact_side(PointId point, PlaneId plane) const;
  Sign exact_compare(PointId p, PointId q, unsigned axis) const;
  Sign exact_turn_any(PointId a, PointId b, PointId c, unsigned axis) const;
  Sign exact_normal_component(PlaneId plane, unsigned axis) const;
  Sign exact_dot(PlaneId p, PlaneId q) const;
  Sign exact_component(LineId line, unsigned axis) const;
  Sign exact_turn(LineId a, LineId b, unsigned axis) const;
  Sign exact_triple(LineId line, PlaneId p, PlaneId q) const;

  std::vector<Point3> points_;         // rounded
  std::vector<filter::Plane> planes_;  // rounded
  std::vector<filter::Line> lines_;    // rounded
  std::size_t explicit_count_ = 0;
  double extent_ = 0;  // see filter::side
  FilterKind filter_kind_ = FilterKind::plain;
  GridClass grid_class_ = GridClass::bits30;
  std::unique_ptr<detail::TierCounter> counter_;
  std::unique_ptr<Store> store_;
};

inline Sign Constructions::orientation(PointId a, PointId b, PointId c, PointId d) const {
  if (filter_kind_ != FilterKind::plain) [[unlikely]]
    return orientation_beyond_plain(a, b, c, d);
  const int sign = filter::orientation(rounded(a), rounded(b), rounded(c), rounded(d));
  return is_decided(sign) ? static_cast<Sign>(sign) : exact_orientation(a, b, c, d);
}

inline Sign Constructions::side(PointId point, PlaneId plane) const {
  const int sign = filter::side(rounded(point), planes_[plane.index()], extent_);
  return is_decided(sign) ? static_cast<Sign>(sign) : exact_side(point, plane);
}

inline Sign Constructions::compare(PointId p, PointId q, unsigned axis) const {
  const double a = rounded(p)[axis];
  const double b = rounded(q)[axis];
  const int sign = static_cast<int>(a > b) - static_cast<int>(a < b);  // rounding is monotone
  if (sign != 0 || (has_exact_doubles(p) && has_exact_doubles(q))) {
    counter_->count_filter();
    return static_cast<Sign>(sign);
  }
  return exact_compare(p, q, axis);
}

inline Sign Constructions::turn(LineId a, LineId b, unsigned axis) const {
  const filter::Line& d = lines_[a.index()];
  const filter::Line& e = lines_[b.index()];
  const unsigned i = (axis + 1) % 3;
  const unsigned j = (axis + 2) % 3;
  const int sign = filter::cross(d[i], d[j], e[i], e[j]);
  return is_decided(sign) ? static_cast<Sign>(sign) : exact_turn(a, b, axis);
}

}  // namespace quoin
