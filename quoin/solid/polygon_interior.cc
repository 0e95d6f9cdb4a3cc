// SPDX-License-Identifier: Apache-2.0
//
// A corner of the polygon next to which a point inside is easy to find: O'Rourke, Computational Geometry in C,
// section 1.4.
#include "quoin/solid/polygon_interior.h"

#include <array>

#include "quoin/base/error.h"

namespace quoin {

namespace {

class PolygonInterior {
 public:
  PolygonInterior(const Constructions& table, std::span<const std::span<const PointId>> loops, unsigned axis,
                  Sign orientation)
      : table_(table), loops_(loops), axis_(axis), positive_(orientation == Sign::positive) {}

  RationalPoint3 point() const {
    const auto [a, v, b] = convex_corner();
    const RationalPoint3 pa = table_.exact(a);
    const RationalPoint3 pv = table_.exact(v);
    const RationalPoint3 pb = table_.exact(b);
    Rational best(0);
    PointId deepest;
    for (const std::span<const PointId> loop : loops_) {
      for (const PointId w : loop) {
        if (w == a || w == v || w == b) continue;
        const RationalPoint3 pw = table_.exact(w);
        const Rational depth = left(pb, pa, pw);
        if (depth.sign() == Sign::negative || left(pa, pv, pw).sign() == Sign::negative ||
            left(pv, pb, pw).sign() == Sign::negative) {
          continue;
        }
        if (deepest.is_none() || depth > best) {
          best = depth;
          deepest = w;
        }
      }
    }
    if (deepest.is_none()) return (pa + pv + pb) * (Rational(1) / Rational(3));
    return (pv + table_.exact(deepest)) * Rational(0.5);
  }

 private:
  // Twice the area to the left of a, b, c.
  Rational left(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c) const {
    Rational area = projected_area(a, b, c, axis_);
    return positive_ ? area : -area;
  }

  bool less(PointId p, PointId q) const {
    const Sign first = table_.compare(p, q, (axis_ + 1) % 3);
    if (first != Sign::zero) return first == Sign::negative;
    return table_.compare(p, q, (axis_ + 2) % 3) == Sign::negative;
  }

  // At the lexicographically smallest vertex: one of the passes through it turns left.
  std::array<PointId, 3> convex_corner() const {
    PointId smallest = loops_[0][0];
    for (const std::span<const PointId> loop : loops_) {
      for (const PointId p : loop) {
        if (p != smallest && less(p, smallest)) smallest = p;
      }
    }
    for (const std::span<const PointId> loop : loops_) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (loop[i] != smallest) continue;
        const PointId before = loop[i == 0 ? loop.size() - 1 : i - 1];
        const PointId after = loop[i + 1 == loop.size() ? 0 : i + 1];
        if (left(table_.exact(before), table_.exact(smallest), table_.exact(after)).sign() == Sign::positive) {
          return {before, smallest, after};
        }
      }
    }
    throw InternalError("a polygon has no convex corner");
  }

  const Constructions& table_;
  std::span<const std::span<const PointId>> loops_;
  unsigned axis_;
  bool positive_;
};

}  // namespace

RationalPoint3 interior_point(const Constructions& table, std::span<const std::span<const PointId>> loops,
                              unsigned axis, Sign orientation) {
  return PolygonInterior(table, loops, axis, orientation).point();
}

}  // namespace quoin
