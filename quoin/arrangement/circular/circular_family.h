// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "quoin/arrangement/circular/circular_support.h"
#include "quoin/arrangement/curve_family.h"
#include "quoin/arrangement/pieces.h"
#include "quoin/arrangement/surface.h"
#include "quoin/arrangement/sweep/crossing_list.h"
#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// Circles, circular arcs and line segments of the plane together, exact.
///
/// Circles have a rational centre and squared radius, lines pass through two rational points, so coordinates of
/// crossings are numbers with one square root. A branch is the lower or the upper half of a circle, both with its
/// x-extremes, or a line. Predicates: doubles with a certified error (filter), then exact arithmetic
/// (circular_exact.h).
///
/// Coordinates must be zero or, like radii, between 2^-200 and 2^200 in magnitude, so that no product in a filter
/// leaves the range of doubles. What adds is told a `name` for the message of the InputError with which it refuses.
class CircularFamily {
 public:
  using Surface = BoundedPlane;
  using Position = Point2;
  using Point = CircularPoint;
  static constexpr bool meets_once = false;
  static constexpr bool meets_transversally = false;
  /// What ids of an absorbed family were moved by.
  struct Shift {
    std::uint32_t supports = 0;
    std::uint32_t points = 0;
  };

  using Pieces = PieceList<CircularFamily>;
  enum class Direction : std::uint8_t { counterclockwise, clockwise };

  // Input curves, cut at x-extremes. Where one is refused, the list is as before.

  /// Runs counterclockwise: lower half, then upper half.
  CurveId add_circle(Pieces& list, const Point2& centre, double radius, std::string_view name = "circle");
  CurveId add_circle(Pieces& list, const RationalCircle& circle, std::string_view name = "circle");
  CurveId add_segment(Pieces& list, const Point2& from, const Point2& to, std::string_view name = "segment");
  CurveId add_segment(Pieces& list, const RationalPoint2& from, const RationalPoint2& to,
                      std::string_view name = "segment");
  /// The arc of a circle between two different points, which must lie on it exactly.
  CurveId add_arc(Pieces& list, const Point2& centre, double radius, const Point2& from, const Point2& to,
                  Direction direction, std::string_view name = "arc");
  CurveId add_arc(Pieces& list, const RationalCircle& circle, const RationalPoint2& from, const RationalPoint2& to,
                  Direction direction, std::string_view name = "arc");
  /// On a support that is there already.
  CurveId add_arc(Pieces& list, CircularSupportId circle, Point from, Point to, Direction direction,
                  std::string_view name = "arc");
  /// The arc whose `bulge` is the tangent of a quarter of its angle, counterclockwise if positive: its circle is
  /// rational. A segment if it is zero.
  CurveId add_bulge_arc(Pieces& list, const Point2& from, const Point2& to, double bulge,
                        std::string_view name = "arc");
  CurveId add_point(Pieces& list, const Point2& point, std::string_view name = "point");
  CurveId add_point(Pieces& list, const RationalPoint2& point, std::string_view name = "point");

  // Predicates; see CurveFamily.
  Sign compare_xy(const Point& p, const Point& q) const {
    const double difference = p.x - q.x;
    if (std::fabs(difference) > 2 * error_) [[likely]]
      return difference < 0 ? Sign::negative : Sign::positive;
    return compare_close(p, q);
  }
  /// Order by x only.
  Sign compare_x(const Point& p, const Point& q) const;
  Sign compare_y_at_x(const Point& p, BranchId branch) const;
  Sign compare_right(BranchId a, BranchId b, const Point& p) const;
  Sign compare_left(BranchId a, BranchId b, const Point& p) const;
  bool is_vertical(BranchId branch) const { return support_of(branch).vertical; }
  bool same_branch(BranchId a, BranchId b) const;
  static Side side(const Point& /*p*/) { return Side::interior; }
  bool first_meeting(BranchId lower, const Point& lower_end, BranchId upper, const Point& upper_end, const Point& after,
                     Point& out) const;
  /// Where a branch ends, `crosses` tells only whether the curves that go on cross.
  void meetings(BranchId a, BranchId b, std::vector<Meeting<Point>>& out) const;
  /// See PairwiseFamily.
  bool find_crossings(const Pieces& list, const Context& context, CrossingList<Point>& out) const;

  Shift absorb(const CircularFamily& other);
  static Point shifted(const Point& p, const Shift& shift);
  static BranchId shifted(BranchId branch, const Shift& shift) { return BranchId(branch.index() + 2 * shift.supports); }

  Point2 position(const Point& p) const;
  double error() const { return error_; }
  double sweep_key(const Point& p) const { return position(p).x; }
  double key_error() const { return error_; }

  // Supports.
  std::size_t support_count() const { return pools_.supports.size(); }
  static CircularSupportId support(BranchId branch) { return CircularSupportId(branch.index() / 2); }
  static BranchId line_branch(CircularSupportId line) { return BranchId(2 * line.index()); }
  static BranchId lower_half(CircularSupportId circle) { return BranchId(2 * circle.index()); }
  static BranchId upper_half(CircularSupportId circle) { return BranchId(2 * circle.index() + 1); }
  /// Of the half of a circle.
  static bool is_upper(BranchId branch) { return (branch.index() & 1) != 0; }
  bool is_line(CircularSupportId id) const { return pools_.supports[id.index()].is_line(); }
  bool is_line(BranchId branch) const { return support_of(branch).is_line(); }
  /// Doubles of a support, for pictures.
  const CircularSupport& rounded(CircularSupportId id) const { return pools_.supports[id.index()]; }
  RationalCircle circle(CircularSupportId id) const {
    return pools_.exact_circle(static_cast<std::uint32_t>(id.index()));
  }
  /// Two points of a line, the smaller one first.
  RationalLine line(CircularSupportId id) const { return pools_.exact_line(static_cast<std::uint32_t>(id.index())); }
  const CircularPools& pools() const { return pools_; }

  // Supports and points by themselves.

  CircularSupportId add_circle_support(const Point2& centre, double radius, std::string_view name = "circle");
  CircularSupportId add_circle_support(const RationalCircle& circle, std::string_view name = "circle");
  CircularSupportId add_line_support(const Point2& a, const Point2& b, std::string_view name = "line");
  CircularSupportId add_line_support(const RationalPoint2& a, const RationalPoint2& b, std::string_view name = "line");
  Point point(const Point2& p, std::string_view name = "point");
  Point point(const RationalPoint2& p, std::string_view name = "point");
  /// A point that asks only, any finite one: it refers to no support and does not raise the error.
  static Point query(const Point2& p) {
    Point result;
    result.x = p.x;
    result.y = p.y;
    return result;
  }
  /// Notes that p lies on a support, so that this need not be found out again. False if it does not.
  bool put_on(Point& p, CircularSupportId support) const;
  /// Leftmost or rightmost point of a circle.
  Point extreme(CircularSupportId circle, bool right) const;
  /// Common points of two different supports, at most two, in lexicographic order; the number of them.
  int crossings(CircularSupportId a, CircularSupportId b, Point out[2]) const;

 private:
  friend class CircularPairs;
  /// Numbers of a crossing as doubles: at `middle` plus and minus `half`, which is lexicographically positive.
  struct RoundedCrossing {
    double middle_x = 0;
    double middle_y = 0;
    double half_x = 0;
    double half_y = 0;
  };

  CurveId append_circle(Pieces& list, CircularSupportId circle) const;
  template <class Coordinates>
  CurveId append_segment(Pieces& list, const Coordinates& from, const Coordinates& to, std::string_view name);
  bool walks_upper(CircularSupportId circle, const Point& p, bool leaving) const;
  const CircularSupport& support_of(BranchId branch) const { return pools_.supports[branch.index() / 2]; }
  void raise_magnitude(double value);
  Sign compare_close(const Point& p, const Point& q) const;
  Sign compare_y(const Point& p, const Point& q) const;
  Sign compare_y_to_centre(const Point& p, std::uint32_t circle) const;
  Sign side_of(const Point& p, std::uint32_t support) const;
  /// y of p minus that of the centre carries error_ if p is not exact, and u magnitude_ < error_ / 64 if the centre is
  /// rational; rounded once more, by u times itself.
  Sign filtered_half(const Point& p, const CircularSupport& circle, bool& known) const {
    const double y = p.y - circle.y;
    known = true;
    if (p.exact_y && !circle.is_rational()) return sign_of(y);
    if (y > 1.1 * error_) return Sign::positive;
    if (y < -1.1 * error_) return Sign::negative;
    known = false;
    return Sign::zero;
  }
  bool misses(const RoundedCrossing& numbers, int root, BranchId lower, BranchId upper, double from, double to) const;
  Sign turn(const Point& p, std::uint32_t a, std::uint32_t b) const;
  Sign compare_slopes(BranchId a, BranchId b, const Point& p) const;
  Sign compare_curvatures(BranchId a, BranchId b) const;
  Sign compare_squared_radii(std::uint32_t a, std::uint32_t b) const;
  int vertical_direction(BranchId branch, const Point& p) const;
  bool same_support(std::uint32_t a, std::uint32_t b) const;
  bool is_on(const Point& p, BranchId branch) const;
  int common_points(BranchId a, BranchId b, Point out[2]) const;
  /// What the filter knows of a crossing.
  enum class Certainty : std::uint8_t { unknown, none, certified };
  Certainty cross(std::uint32_t a, std::uint32_t b, RoundedCrossing& out) const;
  Certainty cross_circles(const CircularSupport& a, const CircularSupport& b, RoundedCrossing& out) const;
  Certainty cross_circle_line(const CircularSupport& circle, const CircularSupport& line, RoundedCrossing& out) const;
  Certainty cross_lines(const CircularSupport& a, const CircularSupport& b, RoundedCrossing& out) const;
  int cross_exactly(std::uint32_t a, std::uint32_t b, RoundedCrossing& out) const;
  Point crossing_point(std::uint32_t a, std::uint32_t b, int root, const RoundedCrossing& numbers) const;
  Sign find_half(const Point& p, std::uint32_t circle) const;

  CircularPools pools_;
  double magnitude_ = 0;
  double error_ = 0;
};

static_assert(CurveFamily<CircularFamily>);

}  // namespace quoin
