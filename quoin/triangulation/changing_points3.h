// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/large_vector.h"
#include "quoin/kernel/point.h"
#include "quoin/triangulation/delaunay_signs.h"
#include "quoin/triangulation/id_grid.h"
#include "quoin/triangulation/vertex_points.h"

namespace quoin {

/// Points of space that come and go, each with an id that stays while it lives and is used again after; how often each
/// is there; and what the predicates of a triangulation need to know of all of them.
///
/// Where scaling is allowed they are kept times a power of two that brings them into the range of the filters, if that
/// rounds none of them. Bounds grow with each point, and are found anew once more points have gone than are left. So
/// they are never wrong, at times wider than they need be, and take O(1) per change on average.
///
/// If all points lie in a plane, one more may have an id, but not be there: the apex, off the plane.
class ChangingPoints3 {
 public:
  using Site = Point3;
  using Signs = DelaunaySigns;

  explicit ChangingPoints3(Scaling scaling = Scaling::allowed) : scaling_(scaling) {}
  /// Ids are numbers of vertices.
  explicit ChangingPoints3(VertexPoints points, Scaling scaling = Scaling::allowed);

  /// An id for a point, which is finite and without negative zeros: there once. Where it throws nothing has changed.
  /// @throws InputError where there are more than 2^30 ids
  std::uint32_t add(const Point3& p);
  void add_once_more(std::uint32_t id) { ++multiplicity_[id]; }
  void remove_one_of_many(std::uint32_t id) { --multiplicity_[id]; }
  /// Its id may be given to another. Takes no memory after `reserve_for_removals` or an addition that came to nothing.
  void remove(std::uint32_t id);
  void reserve_for_removals();

  std::uint32_t apex() const { return apex_; }
  void add_apex(const Point3& p);
  void remove_apex();
  /// The apex takes the place of a point.
  void turn_into_apex(std::uint32_t id, const Point3& p);
  /// A point takes the place of the apex, and its id.
  std::uint32_t turn_apex_into(const Point3& p);

  /// Of those that are there.
  std::size_t count() const { return count_; }
  /// One past the largest.
  std::size_t id_count() const { return points_.size(); }
  bool is_used(std::uint32_t id) const { return multiplicity_[id] > 0 || id == apex_; }
  std::uint32_t multiplicity(std::uint32_t id) const { return id < points_.size() ? multiplicity_[id] : 0; }
  Point3 original(std::uint32_t id) const {
    const Point3& p = points_[id];
    return {p.x * unscale_, p.y * unscale_, p.z * unscale_};
  }
  /// Ids of points that are there, ascending. O(n).
  std::vector<std::uint32_t> ids() const;
  std::vector<Point3> originals(std::span<const std::uint32_t> ids) const;

  /// One of a box of a grid near the point; else about the nearest of a few, evenly spaced by their ids;
  /// vertex_at_infinity if none of these is there.
  std::uint32_t one_near(const Point3& p) const;

  Point3 site(std::uint32_t id) const { return original(id); }
  /// Lexicographic order.
  bool is_before(std::uint32_t id, const Point3& p) const { return lexicographically_less(original(id), p); }

  /// By id, scaled; valid until the next change, as are signs.
  std::span<const Point3> scaled_points() const { return {points_.data(), points_.size()}; }
  PointExtent extent() const { return extent_.extent(); }
  DelaunaySigns signs() const { return {scaled_points(), extent(), apex_}; }

 private:
  std::uint32_t new_id(const Point3& p);
  void hold(const Point3& p);
  bool is_scale_right(const Point3& p) const;
  void choose_scale(const Point3& p);
  void find_bounds();
  Point3 scaled(const Point3& p) const { return {p.x * scale_, p.y * scale_, p.z * scale_}; }

  Scaling scaling_;
  LargeVector<Point3> points_;  ///< scaled
  std::vector<std::uint32_t> multiplicity_;
  std::vector<std::uint32_t> free_;
  std::uint32_t apex_ = no_vertex;
  std::size_t count_ = 0;
  std::size_t gone_ = 0;  ///< since bounds were found
  IdGrid grid_;           ///< of scaled points
  GrowingExtent extent_;  ///< of the scaled points
  double largest_ = 0;    ///< magnitude of a coordinate as given
  double scale_ = 1;
  double unscale_ = 1;
  double tried_scale_ = 1;  ///< not to be tried again, even if it was not used
};

}  // namespace quoin
