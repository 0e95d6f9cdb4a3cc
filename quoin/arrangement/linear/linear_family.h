// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "quoin/arrangement/curve_family.h"
#include "quoin/arrangement/pieces.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/rational_point.h"

namespace quoin {

/// A point of an arrangement of lines: explicit, the crossing of two supports, or the end of a support at infinity.
///
/// x and y are exact for explicit doubles; otherwise they are off by at most LinearFamily::error of their size. At
/// infinity they mean nothing, except x for the ends of vertical lines, which is exact if the support is.
struct LinearPoint {
  enum : std::uint32_t { explicit_tag = 0xFFFFFFF0U, rational_tag, left_tag, right_tag, bottom_tag, top_tag };

  double x = 0;
  double y = 0;
  std::uint32_t first = 0;              ///< a support, or the index of a rational point
  std::uint32_t second = explicit_tag;  ///< the other support, or a tag

  bool is_explicit() const { return second == explicit_tag; }
  bool is_crossing() const { return second < explicit_tag; }
  bool is_end() const { return second >= left_tag; }
};

/// Segments, rays and lines of the plane. A support is a line through two points, kept as given: doubles, or rationals
/// where a caller constructs. Every support has one branch.
///
/// Points are certified to 2^-46 of the largest coordinate of a support, or of their own size where that is more;
/// comparisons are one subtraction unless points come that close. What the filter leaves open goes to
/// fixed-width integers on the grid of the call, and beyond 124 bits, or for rational input, to rationals.
/// Degrees in the input coordinates: side of a point 2 or 4, order along x of two crossings 5.
class LinearFamily {
 public:
  using Surface = UnboundedPlane;
  using Position = Point2;
  using Point = LinearPoint;
  static constexpr bool meets_once = true;
  static constexpr bool meets_transversally = true;
  struct Shift {
    std::uint32_t supports = 0;
    std::uint32_t rationals = 0;
  };

  // Supports and points.

  /// The line through two different points. @throws InputError on equal or non-finite points; `name` says whose
  BranchId add_line(const Point2& a, const Point2& b, std::string_view name = "line");
  BranchId add_line(const RationalPoint2& a, const RationalPoint2& b, std::string_view name = "line");
  /// @throws InputError on coordinates that are not finite
  static Point point(const Point2& p, std::string_view name = "point");
  Point point(const RationalPoint2& p);
  /// The end of a line at infinity: before all its points, or after all.
  Point first_end(BranchId line) const;
  Point last_end(BranchId line) const;

  // Input curves.

  CurveId add_segment(PieceList<LinearFamily>& list, const Point2& source, const Point2& target,
                      std::string_view name = "segment");
  CurveId add_segment(PieceList<LinearFamily>& list, const RationalPoint2& source, const RationalPoint2& target,
                      std::string_view name = "segment");
  /// From `source` through `through` to infinity.
  CurveId add_ray(PieceList<LinearFamily>& list, const Point2& source, const Point2& through,
                  std::string_view name = "ray");
  CurveId add_line(PieceList<LinearFamily>& list, const Point2& a, const Point2& b, std::string_view name);
  /// A chain of segments as one curve; it is cut at every vertex. At least two vertices, consecutive ones distinct.
  CurveId add_polyline(PieceList<LinearFamily>& list, const std::vector<Point2>& vertices, bool closed = false,
                       std::string_view name = "polyline");
  CurveId add_point(PieceList<LinearFamily>& list, const Point2& p, std::string_view name = "point");

  // The concept; see curve_family.h.

  Sign compare_xy(const Point& p, const Point& q) const {
    if (!p.is_end() && !q.is_end()) [[likely]] {
      const double dx = p.x - q.x;
      if (std::fabs(dx) > comparison_bound(p.x, q.x)) [[likely]]
        return dx < 0 ? Sign::negative : Sign::positive;
      if (p.is_explicit() && q.is_explicit()) {
        if (p.x != q.x) return p.x < q.x ? Sign::negative : Sign::positive;
        return sign_of(p.y - q.y);
      }
    }
    return compare_xy_slowly(p, q);
  }
  Sign compare_y_at_x(const Point& p, BranchId b) const {
    const Line& line = lines_[b.index()];
    const double dx = line.bx - line.ax;
    const double dy = line.by - line.ay;
    const double left = dx * (p.y - line.ay);
    const double right = dy * (p.x - line.ax);
    const double value = left - right;
    // Products of two rounded differences, and their difference: 4 u each term. An error e of p's moves it by
    // e (|dx| + |dy|); rounded supports move both factors of both products.
    double bound = 0x1.08p-51 * (std::fabs(left) + std::fabs(right)) + 0x1p-1000;
    if (!p.is_explicit()) bound += error_of(p) * (std::fabs(dx) + std::fabs(dy));
    if (is_rounded_) bound += rounding_of_sides(p, line);
    if (std::fabs(value) > bound && !p.is_end()) [[likely]]
      return value < 0 ? Sign::negative : Sign::positive;
    return compare_y_at_x_slowly(p, b);
  }
  Sign compare_right(BranchId a, BranchId b, const Point&) const { return compare_slopes(a, b); }
  Sign compare_left(BranchId a, BranchId b, const Point&) const { return -compare_slopes(a, b); }
  bool is_vertical(BranchId b) const;
  bool same_branch(BranchId a, BranchId b) const;
  Side side(const Point& p) const {
    if (!p.is_end()) return Side::interior;
    return static_cast<Side>(p.second - LinearPoint::left_tag + 1);
  }
  bool first_meeting(BranchId lower, const Point& lower_end, BranchId upper, const Point& upper_end, const Point&,
                     Point& out) const {
    return first_meeting(lower, lower_end, upper, upper_end, compare_xy(lower_end, upper_end), out);
  }
  bool first_meeting(BranchId lower, const Point& lower_end, BranchId upper, const Point& upper_end, Sign ends,
                     Point& out) const;
  void meetings(BranchId a, BranchId b, std::vector<Meeting<Point>>& out) const;
  Shift absorb(const LinearFamily& other);
  static Point shifted(const Point& p, const Shift& shift);
  static BranchId shifted(BranchId b, const Shift& shift) { return BranchId(b.value + shift.supports); }
  Point2 position(const Point& p) const { return {p.x, p.y}; }
  double error() const { return error_; }
  double sweep_key(const Point& p) const;
  double key_error() const { return error_; }

  // What other modules ask.

  /// The crossing of two lines that are not parallel.
  Point crossing(BranchId a, BranchId b) const;
  /// Exact coordinates of a point that is not at infinity.
  RationalPoint2 exact(const Point& p) const;
  /// Two exact points of a line, the first lexicographically smaller.
  RationalPoint2 first_support_point(BranchId b) const;
  RationalPoint2 second_support_point(BranchId b) const;
  std::size_t support_count() const { return lines_.size(); }
  /// Positive: the slope of `a` is larger. A vertical line has the largest.
  Sign compare_slopes(BranchId a, BranchId b) const;
  /// Order by x only.
  Sign compare_x(const Point& p, const Point& q) const;

 private:
  struct Line {
    double ax, ay, bx, by;  // a before b in lexicographic order
  };
  static constexpr std::uint32_t no_rational = 0xFFFFFFFFU;

  double error_of(const Point& p) const { return std::max(error_, 0x1p-46 * std::max(std::fabs(p.x), std::fabs(p.y))); }
  double comparison_bound(double x, double y) const {
    return std::max(2 * error_, 0x1p-45 * std::max(std::fabs(x), std::fabs(y)));
  }
  double rounding_of_sides(const Point& p, const Line& line) const {
    const double reach = std::fabs(line.bx - line.ax) + std::fabs(line.by - line.ay) + std::fabs(p.x - line.ax) +
                         std::fabs(p.y - line.ay);
    return error_ * (4 * reach + error_);
  }
  BranchId push_line(const Line& line, std::uint32_t rational);
  bool is_rational(BranchId b) const { return is_rounded_ && rational_of_line_[b.index()] != no_rational; }
  bool is_rational(const Point& p) const;
  void add_piece(PieceList<LinearFamily>& list, BranchId line, const Point& source, const Point& target,
                 CurveId curve) const;
  Sign compare_xy_slowly(const Point& p, const Point& q) const;
  Sign compare_y_at_x_slowly(const Point& p, BranchId b) const;
  Sign compare_at_infinity(BranchId a, BranchId b, Side side) const;
  Sign exact_compare(const Point& p, const Point& q, bool by_y) const;
  Sign exact_side(const Point& p, BranchId b) const;
  Sign exact_side_of_support_point(BranchId of, BranchId line) const;
  Point exact_crossing(BranchId a, BranchId b) const;
  bool promote(Point& p) const;
  template <class N>
  friend class LinearReader;

  std::vector<Line> lines_;
  std::vector<std::uint32_t> rational_of_line_;  // empty while no support is rational
  std::vector<RationalPoint2> rationals_;        // two for each rational support, one for each rational point
  double size_ = 0;                              // largest coordinate of a support
  double error_ = 0;
  bool is_rounded_ = false;  // some support is rational, its doubles are rounded
};

}  // namespace quoin
