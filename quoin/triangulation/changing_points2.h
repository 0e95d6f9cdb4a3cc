// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "quoin/base/large_vector.h"
#include "quoin/kernel/point.h"
#include "quoin/triangulation/regular_predicates2.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin::detail {

constexpr const Point2& place_of(const Point2& p) {
  return p;
}
constexpr const Point2& place_of(const WeightedPoint2& p) {
  return p.point;
}

/// Room for one more, in steps that grow.
template <class List>
void make_room(List& list) {
  if (list.size() == list.capacity()) list.reserve(2 * list.size() + 1);
}

/// Points of the plane that come and go, with weights or without: each has an id that stays while it lives, and is used
/// again after, and is there a number of times. Id 0 is that of the infinite vertex, which does not live.
template <class Point>
class ChangingPoints2 {
 public:
  explicit ChangingPoints2(const Point& infinite) : points_{infinite}, multiplicity_{0} {}

  /// An id for a point, which is there once. Where it throws nothing has changed.
  Vertex2 add(const Point& p) {
    if (free_.empty()) {
      make_room(points_);
      make_room(multiplicity_);
      make_room(free_);  // for `remove`
      free_.push_back(static_cast<std::uint32_t>(points_.size()));
      points_.push_back(p);
      multiplicity_.push_back(0);
    }
    const Vertex2 v(std::size_t{free_.back()});
    free_.pop_back();
    points_[v.index()] = p;
    multiplicity_[v.index()] = 1;
    ++count_;
    return v;
  }
  void add_once_more(Vertex2 v) { ++multiplicity_[v.index()]; }
  void remove_one_of_many(Vertex2 v) { --multiplicity_[v.index()]; }
  /// Takes no memory after `reserve_for_removal`, nor for the point added last.
  void remove(Vertex2 v) {
    free_.push_back(v.value);
    multiplicity_[v.index()] = 0;
    --count_;
  }
  void reserve_for_removal() { make_room(free_); }

  /// Of those that live.
  std::size_t count() const { return count_; }
  /// One past the largest.
  std::size_t id_count() const { return points_.size(); }
  bool lives(Vertex2 v) const { return v.index() < multiplicity_.size() && multiplicity_[v.index()] > 0; }
  std::uint32_t multiplicity(Vertex2 v) const { return multiplicity_[v.index()]; }
  const Point& point(Vertex2 v) const { return points_[v.index()]; }
  /// By id, for predicates; valid until the next change.
  std::span<const Point> points() const { return points_; }

  /// About the nearest to p of a few that live and are good, with evenly spaced ids; none if there is none among them.
  /// Rounded distances do. O(n^(1/3)).
  template <class IsGood>
  Vertex2 one_near(const Point2& p, const IsGood& is_good) const {
    const std::size_t ids = points_.size() - 1;
    const auto samples = 1 + static_cast<std::size_t>(std::cbrt(static_cast<double>(ids)));
    Vertex2 best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < samples; ++i) {
      const Vertex2 v(1 + ids * i / samples);
      if (!lives(v) || !is_good(v)) continue;
      const double distance = std::hypot(place_of(point(v)).x - p.x, place_of(point(v)).y - p.y);
      if (!(distance < least)) continue;
      least = distance;
      best = v;
    }
    return best;
  }

 private:
  LargeVector<Point> points_;
  std::vector<std::uint32_t> multiplicity_;
  std::vector<std::uint32_t> free_;
  std::size_t count_ = 0;
};

}  // namespace quoin::detail
