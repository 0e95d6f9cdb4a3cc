// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "quoin/base/sign.h"
#include "quoin/kernel/constructions.h"
#include "quoin/kernel/constructions_filters.h"
#include "quoin/number/fixed_int.h"
#include "quoin/number/integer.h"
#include "quoin/number/rational.h"

/// The exact tier of Constructions: one table of exact values per grid class.
namespace quoin::detail {

/// Number types of the class whose explicit coordinates are integers |X| < 2^B on the grid.
///
/// Bits of the largest magnitude, by counting terms (a difference of two numbers below 2^k is below 2^(k + 1), a sum of
/// three below 3 * 2^k); one more bit holds the sign.
///   difference of coordinates                                B + 1
///   normal n: difference of products of differences          2B + 3
///   offset e = n . p: 3 * 2^(3B + 3)                         3B + 5
///   orientation: n . difference, 3 * 2^(3B + 4)              3B + 6
///   line and plane: W = n . (q - p), as orientation; X = W p + (e - n . p)(q - p), below 4B + 8
///   three planes: W = det(n1, n2, n3): 6 * 2^(6B + 9)        6B + 12
///                 X = sum of e_i (n_j x n_k): 9 * 2^(7B + 10)  7B + 14
///   three weighted points: W < 2^22, X < 2^(B + 22)          (B >= 2 so that they fit the widths of three planes)
///   side: n . X - e W: 3 * 9 * 2^(9B + 13) + 18 * 2^(9B + 12)  9B + 19
///   turn of two explicit points and any: difference (X - x W): 12 * 2^(7B + 10), twice: 24 * 2^(8B + 11), below 9B +
///   19 explicit coordinate against any: X - x W: 12 * 2^(7B + 10)  7B + 14 coordinates of two constructed points: X W'
///   - X' W: 2 * 54 * 2^(13B + 19)  13B + 26 direction of a line: n x n'                              4B + 7 n . n': 3
///   * 2^(4B + 6)                                   4B + 8 turn of two directions: 2 * 2^(8B + 14)                  8B
///   + 15 direction . (n x n'): 3 * 2^(8B + 14)                    8B + 16
template <std::size_t B>
struct FixedNumbers {
  using Coordinate = FixedInt<limbs_for_bits(B + 2)>;
  using Normal = FixedInt<limbs_for_bits(2 * B + 4)>;
  using Offset = FixedInt<limbs_for_bits(3 * B + 7)>;
  using Weight = FixedInt<limbs_for_bits(6 * B + 13)>;
  using Numerator = FixedInt<limbs_for_bits(7 * B + 15)>;
  using LineNumerator = FixedInt<limbs_for_bits(4 * B + 9)>;
  using Direction = FixedInt<limbs_for_bits(4 * B + 8)>;
  using Dot = FixedInt<limbs_for_bits(4 * B + 9)>;
  using Turn = FixedInt<limbs_for_bits(8 * B + 16)>;
  using Triple = FixedInt<limbs_for_bits(8 * B + 17)>;
  using Side = FixedInt<limbs_for_bits(9 * B + 20)>;
  using Comparison = FixedInt<limbs_for_bits(13 * B + 27)>;
};

/// All quantities in one number type without bounds.
template <class Number>
struct UnboundedNumbers {
  using Coordinate = Number;
  using Normal = Number;
  using Offset = Number;
  using Weight = Number;
  using Numerator = Number;
  using LineNumerator = Number;
  using Direction = Number;
  using Dot = Number;
  using Turn = Number;
  using Triple = Number;
  using Side = Number;
  using Comparison = Number;
};

using Numbers30 = FixedNumbers<30>;
using Numbers61 = FixedNumbers<61>;
using Numbers124 = FixedNumbers<124>;
using NumbersBig = UnboundedNumbers<Integer>;
using NumbersRational = UnboundedNumbers<Rational>;

/// Explicit points given as doubles, or as sums of two of which the first is the nearest double; multiples of 2^lo.
/// The (first) doubles are kept by Constructions; all are read as integers.
template <class Numbers>
class ExplicitPoints {
 public:
  using Coordinate = typename Numbers::Coordinate;
  /// `tails` are the second doubles; none if all are zero.
  ExplicitPoints(const Point3* points, std::vector<Point3> tails, int lo)
      : points_(points),
        tails_(std::move(tails)),
        lo_(lo),
        scale_first_(std::ldexp(1.0, -lo / 2)),
        scale_second_(std::ldexp(1.0, -lo - (-lo / 2))) {}
  void set_array(const Point3* points) { points_ = points; }
  int lo() const { return lo_; }
  Coordinate coordinate(PointId point, unsigned axis) const {
    Coordinate result = in_units(points_[point.index()][axis]);
    if (!tails_.empty()) result = result + in_units(tails_[point.index()][axis]);
    return result;
  }
  std::array<Coordinate, 3> operator[](PointId point) const {
    return {coordinate(point, 0), coordinate(point, 1), coordinate(point, 2)};
  }
  bool is_double(PointId point) const { return tails_.empty() || tails_[point.index()] == Point3{}; }
  /// The chosen points, which `points` holds.
  ExplicitPoints chosen(std::span<const PointId> chosen, const Point3* points) const {
    std::vector<Point3> tails;
    if (!tails_.empty()) {
      for (const PointId p : chosen) tails.push_back(tails_[p.index()]);
    }
    return ExplicitPoints(points, std::move(tails), lo_);
  }

 private:
  Coordinate in_units(double x) const;

  const Point3* points_;
  std::vector<Point3> tails_;
  int lo_;
  double scale_first_;  // x 2^-lo = x * scale_first_ * scale_second_, neither product rounding
  double scale_second_;
};

/// Explicit points given as rationals.
template <>
class ExplicitPoints<NumbersRational> {
 public:
  explicit ExplicitPoints(std::vector<RationalPoint3> points) : points_(std::move(points)) {}
  void set_array(const Point3*) {}
  int lo() const { return 0; }
  const Rational& coordinate(PointId point, unsigned axis) const {
    const RationalPoint3& p = points_[point.index()];
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  }
  std::array<Rational, 3> operator[](PointId point) const {
    const RationalPoint3& p = points_[point.index()];
    return {p.x, p.y, p.z};
  }
  ExplicitPoints chosen(std::span<const PointId> points, const Point3*) const {
    std::vector<RationalPoint3> result;
    result.reserve(points.size());
    for (const PointId p : points) result.push_back(points_[p.index()]);
    return ExplicitPoints(std::move(result));
  }

 private:
  std::vector<RationalPoint3> points_;
};

/// Exact values of planes, lines and constructed points, and the predicates on them.
///
/// Everything is in units of the grid, 2^lo. Explicit points are the ids below explicit_count.
template <class N>
class ExactTable {
 public:
  ExactTable(ExplicitPoints<N> points, std::size_t explicit_count)
      : explicit_(std::move(points)), explicit_count_(explicit_count) {}

  void resize_points(std::size_t constructed, const Point3* points) {
    explicit_.set_array(points);
    points_.resize(constructed);
  }
  void resize_planes(std::size_t count) { planes_.resize(count); }
  void resize_lines(std::size_t count) { lines_.resize(count); }

  filter::Plane set_plane(PlaneId plane, PointId a, PointId b, PointId c);
  filter::Plane set_axis_plane(PlaneId plane, PointId p, PointId q, unsigned axis);
  filter::Line set_line(LineId line, PointId p, PointId q);
  filter::Line set_line(LineId line, PlaneId p, PlaneId q);
  Point3 set_point(PointId point, PointId p, PointId q, PlaneId plane);
  Point3 set_crossing(PointId point, PointId p, PointId q, PointId r, PointId s, unsigned axis);
  Point3 set_point(PointId point, PlaneId p, PlaneId q, PlaneId r);
  Point3 set_point(PointId point, std::array<PointId, 3> corners, std::array<std::uint32_t, 3> weights);
  Point3 round(PointId point) const;

  Sign orientation(PointId a, PointId b, PointId c, PointId d) const;
  Sign turn(PointId a, PointId b, PointId c, unsigned axis) const;
  Sign side(PointId point, PlaneId plane) const;
  Sign compare(PointId p, PointId q, unsigned axis) const;
  Sign turn_any(PointId a, PointId b, PointId c, unsigned axis) const;
  Sign normal_component(PlaneId plane, unsigned axis) const;
  Sign dot(PlaneId p, PlaneId q) const;
  Sign component(LineId line, unsigned axis) const;
  Sign turn(LineId a, LineId b, unsigned axis) const;
  Sign triple(LineId line, PlaneId p, PlaneId q) const;

  /// (x, y, z, w), the coordinates x / w, y / w, z / w in units of the grid, w positive.
  std::array<Integer, 4> homogeneous(PointId point) const;
  /// Up to a positive factor.
  std::array<Integer, 3> direction(LineId line) const;
  RationalPoint3 exact(PointId point) const;
  bool is_exact(PointId point, const Point3& rounded) const;
  std::array<Rational, 4> plane_equation(PlaneId plane) const;
  /// The table of `points`, of which the first `explicit_count` are explicit; `rounded` are its rounded points.
  ExactTable subset(std::span<const PointId> points, std::size_t explicit_count, const Point3* rounded) const;

 private:
  struct Plane {
    std::array<typename N::Normal, 3> normal;
    typename N::Offset offset;
  };
  struct Line {
    std::array<typename N::Direction, 3> direction;
  };
  // numerator / weight, weight positive
  struct Point {
    std::array<typename N::Numerator, 3> numerator;
    typename N::Weight weight;
  };

  bool is_explicit(PointId point) const { return point.index() < explicit_count_; }
  Point& constructed(PointId point) { return points_[point.index() - explicit_count_]; }
  const Point& constructed(PointId point) const { return points_[point.index() - explicit_count_]; }
  const Plane& plane(PlaneId id) const { return planes_[id.index()]; }
  std::array<typename N::Coordinate, 3> difference(PointId q, PointId p) const;
  typename N::Offset offset_at(const Plane& plane, PointId p) const;
  Plane axis_plane(PointId p, PointId q, unsigned axis) const;
  Point3 set_meeting(PointId point, PointId p, PointId q, const Plane& plane);
  filter::Plane finish(Plane& plane) const;
  filter::Line finish(Line& line) const;
  Point3 finish(PointId point);

  ExplicitPoints<N> explicit_;
  std::size_t explicit_count_;
  std::vector<Plane> planes_;
  std::vector<Line> lines_;
  std::vector<Point> points_;
};

extern template class ExactTable<Numbers30>;
extern template class ExactTable<Numbers61>;
extern template class ExactTable<Numbers124>;
extern template class ExactTable<NumbersBig>;
extern template class ExactTable<NumbersRational>;

}  // namespace quoin::detail
