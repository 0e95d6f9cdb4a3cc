// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/arrangement/curve_family.h"
#include "quoin/arrangement/geodesic/direction_pool.h"
#include "quoin/arrangement/geodesic/plane_index.h"
#include "quoin/arrangement/geodesic/sphere_direction.h"
#include "quoin/arrangement/pieces.h"
#include "quoin/arrangement/surface.h"
#include "quoin/arrangement/sweep/crossing_list.h"
#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"
#include "quoin/number/integer.h"

namespace quoin {

/// Arcs of great circles on the sphere, with rational arithmetic only: no direction is ever normalised.
///
/// u is the longitude in [-pi, pi], v the latitude. A *support* is a great circle, known by its primitive integer
/// normal with n.z > 0, or n.z = 0 and the first nonzero component positive; equal circles are one support, whoever
/// added them. A circle that is not vertical is one branch, from the left side of the parameter rectangle to the right
/// side. A vertical one (n.z = 0) is two branches, half meridians from pole to pole.
///
/// A *point* is a direction of the input or a crossing +-(m x n) of two supports. Points on the identification, the
/// half meridian through (-1, 0, 0), have a left copy that starts pieces and a right copy that ends them; vertical
/// pieces inside the identification have left copies only. At a pole a point is an end on the bottom or top side, at
/// the longitude of its meridian, so one pole has many of them. In the total order points with u = -pi come first, then
/// all others by u, the right copies last; at equal u the bottom end precedes all others and the top end follows. The
/// arrangement merges copies and pole ends.
///
/// Signs cost a scalar product of doubles where its certified error allows, else integers of 1, 2 or 4 words (normals
/// up to 62, 126, 254 bits), else of any size; with m bits in normals the predicates need 4 m + 3. Nothing is allocated
/// unless normals exceed 254 bits. Source: Fogel, Minkowski sum construction and other applications of arrangements of
/// geodesic arcs on the sphere (2009), section 2.6; order at equal longitude by the horizontal part, not by squares.
class GeodesicFamily {
 public:
  using Surface = Sphere;
  using Position = Vector3;
  static constexpr bool meets_once = false;
  static constexpr bool meets_transversally = true;

  /// See the class. At most 48 bytes.
  struct Point {
    double longitude_key = 0;     ///< in [-2, 2], monotone in u; -2 and 2 are the sides
    Vector3 approximate;          ///< unit vector; its components have the exact signs. At a pole: (cos u, sin u, 0)
    std::uint32_t first = 0;      ///< a direction of the pool, or the smaller of two supports
    std::uint32_t second = none;  ///< the larger of two supports, or none
    Side side = Side::interior;
    std::int8_t column = 0;  ///< -1 where u = -pi, 1 where u = pi
    std::int8_t sign = 1;    ///< the crossing is sign (n_first x n_second)
    std::uint8_t tier = 0;   ///< words of a normal that exact arithmetic needs: 1, 2, 4, or `any_size`

    static constexpr std::uint32_t none = 0xFFFFFFFFU;
    bool is_crossing() const { return second != none; }
    bool is_crossing_of(std::uint32_t support) const {
      return is_crossing() && (first == support || second == support);
    }
    bool same_definition(const Point& other) const {
      return first == other.first && second == other.second && sign == other.sign && side == other.side;
    }
  };
  static constexpr std::uint8_t any_size = 255;

  /// Numbers that supports and directions of an absorbed family have got.
  struct Shift {
    std::vector<std::uint32_t> supports;
    std::vector<std::uint32_t> directions;
    std::vector<std::uint8_t> tiers;  ///< of the supports as they are kept here, perhaps by longer normals
  };

  // Input curves. All throw InputError naming the curve, without having added anything, for vectors that are zero or
  // not finite.

  /// The arc shorter than pi. @throws InputError also where the ends are equal or antipodal, which leaves the plane
  /// open
  CurveId add_arc(PieceList<GeodesicFamily>& list, const SphereDirection& source, const SphereDirection& target);
  /// The arc that leaves the source counterclockwise about the normal and ends where it first meets the target; equal
  /// ends mean the full circle, cut at the source. @throws InputError also where an end is not exactly on the plane
  CurveId add_arc(PieceList<GeodesicFamily>& list, const SphereDirection& source, const SphereDirection& target,
                  const SphereDirection& normal);
  /// The circle, counterclockwise about the normal. It is cut at the identification, or at the poles if it is vertical.
  CurveId add_great_circle(PieceList<GeodesicFamily>& list, const SphereDirection& normal);
  /// A lone point: on the identification its left copy, at a pole the end with u = -pi.
  CurveId add_point(PieceList<GeodesicFamily>& list, const SphereDirection& direction);
  /// The point add_point would add, for queries. @throws InputError
  Point make_point(const SphereDirection& direction);

  // The concept.

  Sign compare_xy(const Point& p, const Point& q) const {
    if (p.column != q.column) return p.column < q.column ? Sign::negative : Sign::positive;
    const double difference = p.longitude_key - q.longitude_key;
    if (std::fabs(difference) > 2 * key_error()) return sign_of(difference);
    return compare_close(p, q);
  }
  Sign compare_y_at_x(const Point& p, BranchId b) const {
    if (p.side == Side::bottom || p.side == Side::top || is_vertical(b)) return side_at_pole(p, b);
    const Vector3& n = supports_[support(b)].normal;
    const double product = n.x * p.approximate.x + n.y * p.approximate.y + n.z * p.approximate.z;
    if (std::fabs(product) > (p.is_crossing() ? crossing_side_error : direction_side_error)) return sign_of(product);
    return compare_y_at_x_exact(p, b);
  }
  Sign compare_right(BranchId b, BranchId c, const Point& p) const;
  Sign compare_left(BranchId b, BranchId c, const Point& p) const { return -compare_right(b, c, p); }
  bool is_vertical(BranchId b) const { return supports_[support(b)].is_vertical; }
  bool same_branch(BranchId b, BranchId c) const { return b == c; }
  Side side(const Point& p) const { return p.side; }

  bool first_meeting(BranchId lower, const Point& lower_end, BranchId upper, const Point& upper_end, const Point& after,
                     Point& out) const;
  /// Two that are not vertical meet in two antipodal points; one on the identification is reported as both copies.
  void meetings(BranchId b, BranchId c, std::vector<Meeting<Point>>& out) const;
  /// See PairwiseFamily.
  bool find_crossings(const PieceList<GeodesicFamily>& list, const Context& context, CrossingList<Point>& out) const;

  Shift absorb(const GeodesicFamily& other);
  static Point shifted(const Point& p, const Shift& shift);
  static BranchId shifted(BranchId b, const Shift& shift);

  /// Unit vector, each coordinate within error() of the true one.
  Vector3 position(const Point& p) const;
  double error() const { return 0x1p-42; }
  double sweep_key(const Point& p) const { return p.longitude_key; }
  double key_error() const { return 0x1p-42; }
  /// The copy on the left side of a point on the right side; other points are returned as they are.
  Point left_copy(const Point& p) const;

  // More than the concept asks.

  /// Both branches are of one great circle.
  bool same_plane(BranchId b, BranchId c) const { return support(b) == support(c); }
  /// The exact direction, primitive.
  std::array<Integer, 3> direction(const Point& p) const;
  /// The primitive normal about which the branch runs counterclockwise from left to right (upward if vertical).
  std::array<Integer, 3> normal(BranchId b) const;
  /// Unit vectors along a branch from one of its points to another, both included, at most max_angle (> 0) apart: for
  /// pictures.
  std::vector<Vector3> flatten(BranchId b, const Point& left, const Point& right, double max_angle) const;
  std::size_t support_count() const { return supports_.size(); }

  // Supports, branches and points by their definitions.

  static std::uint32_t support(BranchId b) { return b.value / 2; }
  static bool is_second_half(BranchId b) { return b.value % 2 != 0; }
  static BranchId branch(std::uint32_t support, bool second_half) {
    return BranchId(2 * std::size_t{support} + (second_half ? 1 : 0));
  }
  /// The support with this normal or the opposite one, new or known. @throws InputError on what is no direction
  std::uint32_t add_circle(const SphereDirection& normal);
  /// The point sign (n_a x n_b) of two supports; on the identification its left copy.
  /// @throws InputError if it is the same support twice, or both pass through the poles
  Point make_crossing(std::uint32_t a, std::uint32_t b, int sign) const;
  /// Where a vertical branch ends at the bottom or top side.
  Point make_pole_end(BranchId vertical, Side side);
  /// The copy on the right side of a point on the left side; other points are returned as they are.
  static Point right_copy(const Point& p) { return p.side == Side::left ? on_side(p, Side::right) : p; }

 private:
  friend class GeodesicPairs;
  struct Support {
    Vector3 normal;  ///< times a power of two: the largest component in [1/2, 1], each within a relative error of 2^-53
    std::uint8_t tier = 0;
    bool is_vertical = false;
  };
  // Bounds of |n . p|, derived in geodesic_points.cc.
  static constexpr double crossing_side_error = 0x1p-41;
  static constexpr double direction_side_error = 0x1p-49;

  static bool is_on_identification(const Vector3& v) { return v.x < 0 && v.y == 0; }
  static bool is_at_pole(const Vector3& v) { return v.x == 0 && v.y == 0; }
  static int level(const Point& p) { return p.side == Side::bottom ? -1 : p.side == Side::top ? 1 : 0; }

  // Supports and points (geodesic_points.cc).
  std::uint32_t add_support(const SphereDirection& canonical);
  /// Keeps the last normal as a new support, or takes it away if its plane is known.
  std::uint32_t settle_support(const Support& added);
  Support make_support(std::uint32_t index) const;
  bool are_parallel(std::uint32_t a, std::uint32_t b) const;
  Point direction_point(const SphereDirection& direction);
  /// The end on the bottom or top side at the longitude of a horizontal direction.
  Point pole_end(const SphereDirection& horizontal, Side side);
  /// The point n_a x n_b; on the identification its left copy.
  Point crossing(std::uint32_t a, std::uint32_t b) const;
  bool place_filtered(Point& p, const Vector3& a, const Vector3& b) const;
  void place_exact(Point& p) const;
  static void set_column(Point& p, Side side);
  static Point antipode(const Point& p);
  static Point on_side(Point p, Side side);

  // Exact tiers (geodesic_family.cc).
  Sign compare_close(const Point& p, const Point& q) const;
  Sign compare_longitude_exact(const Point& p, const Point& q) const;
  Sign compare_latitude(const Point& p, const Point& q) const;
  Sign compare_y_at_x_exact(const Point& p, BranchId b) const;
  Sign side_at_pole(const Point& p, BranchId b) const;
  Sign compare_slopes(std::uint32_t a, std::uint32_t b, const Point& p) const;
  bool first_meeting_vertical(BranchId vertical, const Point& vertical_end, BranchId other, const Point& other_end,
                              const Point& after, Point& out) const;
  Point vertical_meeting(BranchId vertical, BranchId other) const;

  // Input (geodesic_input.cc).
  CurveId add_checked_arc(PieceList<GeodesicFamily>& list, const SphereDirection& source, const SphereDirection& target,
                          const SphereDirection& normal);
  struct Tour;
  void add_flat(const Tour& tour, const Point& from, const Point& to);
  void add_vertical(const Tour& tour, const Point& from, const Point& to);
  void add_meridian_piece(const Tour& tour, bool second_half, const Point* low, const Point* high);

  DirectionPool directions_;  ///< of the input and of cuts
  DirectionPool normals_;     ///< of supports, with their numbers
  PlaneIndex planes_;         ///< finds supports by their normals
  std::vector<Support> supports_;
};

}  // namespace quoin
