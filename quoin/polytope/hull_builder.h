// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/large_vector.h"
#include "quoin/base/sign.h"
#include "quoin/kernel/constructions.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// A convex hull of dimension 3 that grows point by point, as triangles; coplanar ones stay apart.
///
/// A point that no triangle sees (strictly, from outside) changes nothing, so points on the hull are no corners of it
/// unless they came before what covers them. A point outside is located by a walk: from a triangle, through the edge
/// that separates the point from it as seen from a point inside the hull, and so on. The walk ends, because triangles
/// seen from inside are a projected convex surface. What the point sees is a disc; new triangles join its rim to it.
class HullBuilder {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  /// Triangle {corners, across}: across[k] is its neighbour at the edge from corner k to the next. A free place has no
  /// corners.
  struct Triangle {
    std::array<std::uint32_t, 3> corners;
    std::array<std::uint32_t, 3> across;
    std::uint32_t mark;
    float slack;  ///< error of `plane` at any of the points
    bool is_free() const { return corners[0] == none; }
  };

  /// The points stay where they are while the builder lives. The first four are affinely independent.
  /// @throws Cancelled
  HullBuilder(std::span<const Point3> points, const Context& context);
  /// Of points of a table, by their rounded coordinates and their ids; both stay where they are.
  HullBuilder(std::span<const Point3> rounded, const Constructions& table, std::span<const PointId> ids,
              const Context& context);

  /// For as many points on the hull.
  void reserve(std::size_t vertices);
  /// Adds a point; false if it is in the hull already.
  bool insert(std::uint32_t point) { return insert(single_, point) == Place::outside; }
  /// Adds points first ... end - 1, of which equal ones come in the order of their importance: only the first of them
  /// may become a corner. On several threads where there are many (hull_sides.cc); not for points of a table.
  /// @throws Cancelled; the hull is of no use then
  void insert_many(std::uint32_t first, std::uint32_t end, const Context& context);

  /// What insert_many shared among threads until now.
  struct Tally {
    std::size_t most_sides = 0;  ///< of one cut of points into sides; 0: all were inserted one by one
    std::size_t on_sides = 0;    ///< points that were handed to threads
    std::size_t late = 0;        ///< of these, points that waited until the threads were done
    std::size_t renamed = 0;     ///< corners that gave way to an equal point that is earlier in the list
  };
  const Tally& tally() const { return tally_; }

  std::span<const Point3> points() const { return points_; }
  /// Free ones among them.
  std::span<const Triangle> triangles() const { return triangles_; }
  /// Where a point of the list lies to the plane of a triangle: positive outside.
  Sign side(std::uint32_t triangle, std::uint32_t point) const {
    const double value = distance(triangle, points_[point]);
    const double slack = triangles_[triangle].slack;
    if (value > slack) return Sign::positive;
    if (value < -slack) return Sign::negative;
    return exact_side(triangle, point);
  }
  /// In doubles; off by the triangle's `slack` at most for every point of the list.
  struct Plane {
    double x;
    double y;
    double z;
    double offset;
  };
  const Plane& plane(std::uint32_t triangle) const { return planes_[triangle]; }
  /// When they are asked for no more.
  void drop_planes() { UnsetVector<Plane>().swap(planes_); }
  void drop_triangles() { UnsetVector<Triangle>().swap(triangles_); }
  /// In magnitude, of all points.
  double largest_coordinate() const { return largest_; }
  /// A point inside, if some double is.
  const Point3* centre() const { return has_centre_ ? &centre_ : nullptr; }

 private:
  struct Edge {
    std::uint32_t triangle;
    unsigned index;
  };
  enum class Place { outside, inside, border };
  struct Found {
    std::uint32_t triangle;
    Place place;
  };
  /// What one thread inserts with. Marks of triangles: the epoch of what the last point sees, and one more of what was
  /// asked and does not.
  struct alignas(64) Hand {
    std::vector<std::uint32_t> free;
    std::uint32_t fresh = 0;  // to fresh_end: triangles that were never used
    std::uint32_t fresh_end = 0;
    bool may_grow = true;  // when these are used up
    std::uint32_t epoch = 0;
    std::uint32_t hint = 0;
    std::uint32_t border = no_mark;  // the mark of triangles that it must not replace
    std::vector<std::uint32_t> visible;
    std::size_t inserted = 0;
    bool has_room(std::size_t count) const { return may_grow || free.size() + (fresh_end - fresh) >= count; }
  };
  static constexpr std::uint32_t no_mark = 1;  // epochs are even and begin at 2
  static constexpr std::uint32_t border_mark = none;
  struct Sides;

  static unsigned next(unsigned k) { return k == 2 ? 0 : k + 1; }
  static unsigned index_of(const Triangle& triangle, std::uint32_t neighbour) {
    return triangle.across[0] == neighbour ? 0 : triangle.across[1] == neighbour ? 1 : 2;
  }
  double distance(std::uint32_t triangle, const Point3& p) const {
    const Plane& plane = planes_[triangle];
    return plane.x * p.x + plane.y * p.y + plane.z * p.z - plane.offset;
  }
  void start(const Context& context);
  Sign orientation_of(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;
  RationalPoint3 exact(std::uint32_t point) const;
  Sign exact_side(std::uint32_t triangle, std::uint32_t point) const;
  void find_centre();
  Sign side_from_centre(const Triangle& triangle, unsigned edge, std::uint32_t point) const;
  Sign side_from_mean(const Triangle& triangle, unsigned edge, std::uint32_t point) const;
  Place insert(Hand& hand, std::uint32_t point);
  Found locate(const Hand& hand, std::uint32_t point) const;
  Edge mark_visible(Hand& hand, std::uint32_t first, std::uint32_t point);
  void replace_visible(Hand& hand, const Edge& rim, std::uint32_t point);
  std::uint32_t new_triangle(Hand& hand, std::uint32_t a, std::uint32_t b, std::uint32_t c);

  void insert_one_by_one(std::uint32_t first, std::uint32_t end, const Context& context);
  void mark_borders(Sides& sides, std::uint32_t first, std::uint32_t end, const Context& context);
  void hand_out_triangles(Sides& sides, std::uint32_t count);
  void take_back(Sides& sides);
  void insert_side(Sides& sides, std::size_t side, std::uint32_t first, std::uint32_t end, const Context& context);
  void insert_late(std::uint32_t point);

  std::span<const Point3> points_;
  const Constructions* table_ = nullptr;  // if the points are but rounded
  std::span<const PointId> ids_;
  double largest_ = 0;  // coordinate
  UnsetVector<Triangle> triangles_;
  UnsetVector<Plane> planes_;
  Hand single_;
  Tally tally_;
  double rate_ = 1;  // part of the points that were outside, lately
  Point3 centre_{};
  bool has_centre_ = false;  // else it is the mean of the first four points: no double is near enough, or they are of a
                             // table
};

}  // namespace quoin
