// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "quoin/kernel/point.h"

namespace quoin {

/// A closed box with sides parallel to the axes, or nothing. Corners are coordinates of what was added, so every answer
/// is exact; no arithmetic happens. A box of one point is a box.
class Box3 {
 public:
  /// Nothing: contains no point, meets no box.
  constexpr Box3() = default;
  /// The smallest box with both points.
  constexpr Box3(const Point3& a, const Point3& b) {
    extend(a);
    extend(b);
  }

  constexpr bool is_empty() const { return low_.x > high_.x; }
  /// Smallest and largest coordinates; of an empty box, +infinity and -infinity.
  constexpr const Point3& low() const { return low_; }
  constexpr const Point3& high() const { return high_; }

  constexpr void extend(const Point3& p) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(low_[axis], p[axis]);
      high_[axis] = std::max(high_[axis], p[axis]);
    }
  }
  constexpr void extend(const Box3& other) {
    if (other.is_empty()) return;
    extend(other.low_);
    extend(other.high_);
  }

  constexpr bool contains(const Point3& p) const {
    bool result = true;
    for (unsigned axis = 0; axis < 3; ++axis) result = result && low_[axis] <= p[axis] && p[axis] <= high_[axis];
    return result;
  }
  /// Nothing is contained in every box.
  constexpr bool contains(const Box3& other) const {
    return other.is_empty() || (contains(other.low_) && contains(other.high_));
  }
  /// Whether the boxes share a point, if only on their boundaries.
  constexpr bool overlaps(const Box3& other) const {
    bool result = true;
    for (unsigned axis = 0; axis < 3; ++axis) {
      result = result && low_[axis] <= other.high_[axis] && other.low_[axis] <= high_[axis];
    }
    return result;
  }

  friend constexpr bool operator==(const Box3&, const Box3&) = default;

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Point3 low_{infinity, infinity, infinity};
  Point3 high_{-infinity, -infinity, -infinity};
};

/// The same in the plane.
class Box2 {
 public:
  constexpr Box2() = default;
  constexpr Box2(const Point2& a, const Point2& b) {
    extend(a);
    extend(b);
  }

  constexpr bool is_empty() const { return low_.x > high_.x; }
  constexpr const Point2& low() const { return low_; }
  constexpr const Point2& high() const { return high_; }

  constexpr void extend(const Point2& p) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  constexpr void extend(const Box2& other) {
    if (other.is_empty()) return;
    extend(other.low_);
    extend(other.high_);
  }

  constexpr bool contains(const Point2& p) const {
    return low_.x <= p.x && p.x <= high_.x && low_.y <= p.y && p.y <= high_.y;
  }
  constexpr bool contains(const Box2& other) const {
    return other.is_empty() || (contains(other.low_) && contains(other.high_));
  }
  constexpr bool overlaps(const Box2& other) const {
    return low_.x <= other.high_.x && other.low_.x <= high_.x && low_.y <= other.high_.y && other.low_.y <= high_.y;
  }

  friend constexpr bool operator==(const Box2&, const Box2&) = default;

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Point2 low_{infinity, infinity};
  Point2 high_{-infinity, -infinity};
};

}  // namespace quoin
