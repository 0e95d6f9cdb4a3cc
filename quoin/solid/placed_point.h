// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/kernel/constructions.h"

namespace quoin {

/// Any rational point, against the points of a table it does not belong to.
///
/// Every sign is exact: a filter on rounded coordinates (bounds derived in placed_point.cc), then rationals. The table
/// must outlive it.
class PlacedPoint {
 public:
  PlacedPoint(const Constructions& table, RationalPoint3 point);

  const RationalPoint3& exact() const { return exact_; }
  /// Each coordinate rounded to nearest.
  const Point3& rounded() const { return rounded_; }

  /// Sign of p[axis] minus the point's coordinate.
  Sign compare(PointId p, unsigned axis) const;
  bool equals(PointId p) const;
  /// Turn a, b, the point, projected along the axis.
  Sign turn(PointId a, PointId b, unsigned axis) const;
  /// Sign of ((b - a) x (c - a)) . (point - a).
  Sign side(PointId a, PointId b, PointId c) const;

 private:
  const Constructions* table_;
  RationalPoint3 exact_;
  Point3 rounded_;
};

}  // namespace quoin
