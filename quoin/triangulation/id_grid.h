// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/kernel/point.h"

namespace quoin {

/// For each box of a grid over points of space an id of one that was put there last, by which walks find a place to
/// begin. Points that went may still be named; points elsewhere belong to the boxes of the boundary.
class IdGrid {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  /// Of the points of these ids, about two to a box if they are spread evenly. O(n). Where it throws, nothing changes.
  void build(std::span<const Point3> points, std::span<const std::uint32_t> ids);
  void clear() { boxes_.clear(); }
  /// How many points it was built of.
  std::size_t size() const { return boxes_.empty() ? 0 : size_; }

  void put(const Point3& p, std::uint32_t id) {
    if (!boxes_.empty()) boxes_[box_of(place_of(p))] = id;
  }
  /// An id that `is_good`, of the box of p or one that has a side in common with it, whose point is there; else none.
  template <class IsGood>
  std::uint32_t find(const Point3& p, std::span<const Point3> points, const IsGood& is_good) const {
    if (boxes_.empty()) return none;
    const Place place = place_of(p);
    for (std::size_t k = 0; k < 7; ++k) {
      const std::size_t box = box_of(k == 0 ? place : beside(place, k - 1));
      const std::uint32_t id = boxes_[box];
      if (id != none && is_good(id) && box_of(place_of(points[id])) == box) return id;
    }
    return none;
  }

 private:
  using Place = std::array<std::size_t, 3>;

  void choose_boxes(const std::array<double, 3>& extent, std::size_t most);
  Place place_of(const Point3& p) const;
  Place beside(Place place, std::size_t side) const;
  std::size_t box_of(const Place& place) const { return (place[0] * counts_[1] + place[1]) * counts_[2] + place[2]; }

  std::array<double, 3> low_{};
  double per_side_ = 0;
  Place counts_{};
  std::vector<std::uint32_t> boxes_;
  std::size_t size_ = 0;
};

}  // namespace quoin
