// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "quoin/base/sign.h"
#include "quoin/kernel/constructions.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/predicates2.h"

namespace quoin {

/// Points of the plane given as doubles.
class PlainPoints {
 public:
  explicit PlainPoints(std::span<const Point2> points) : points_(points) {}
  std::size_t size() const { return points_.size(); }
  /// Lexicographic order.
  Sign compare(std::uint32_t i, std::uint32_t j) const {
    if (points_[i] == points_[j]) return Sign::zero;
    return lexicographically_less(points_[i], points_[j]) ? Sign::negative : Sign::positive;
  }
  Sign turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return orientation(points_[i], points_[j], points_[k]);
  }

 private:
  std::span<const Point2> points_;
};

/// Explicit points of a table, projected along an axis and seen from its positive end, or from the other one.
class ProjectedPoints {
 public:
  ProjectedPoints(const Constructions& table, std::span<const PointId> points, unsigned axis, bool from_positive)
      : table_(&table), points_(points), axis_(axis), from_positive_(from_positive) {}
  std::size_t size() const { return points_.size(); }
  Sign compare(std::uint32_t i, std::uint32_t j) const {
    const Sign first = table_->compare(points_[i], points_[j], (axis_ + (from_positive_ ? 1 : 2)) % 3);
    return first != Sign::zero ? first
                               : table_->compare(points_[i], points_[j], (axis_ + (from_positive_ ? 2 : 1)) % 3);
  }
  Sign turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    const Sign sign = table_->turn(points_[i], points_[j], points_[k], axis_);
    return from_positive_ ? sign : -sign;
  }

 private:
  const Constructions* table_;
  std::span<const PointId> points_;
  unsigned axis_;
  bool from_positive_;
};

}  // namespace quoin
