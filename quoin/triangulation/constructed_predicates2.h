// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "quoin/kernel/constructions.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin {

/// What the insertion asks, for the points of a table, constructed ones too: vertices are the points' ids, all of them
/// distinct. The same answers as DelaunayPredicates2 gives for doubles, ties included; exact.
class ConstructedPredicates2 {
 public:
  static constexpr bool may_hide = false;
  using Query = PointId;

  explicit ConstructedPredicates2(const Constructions& table) : table_(table) {}

  static PointId point(std::uint32_t v) { return PointId(std::size_t{v}); }
  Sign turn(std::uint32_t a, std::uint32_t b, PointId p) const { return table_.turn_any(point(a), point(b), p, axis); }
  bool in_conflict(const TriangleLinks2& t, PointId d) const;

 private:
  static constexpr unsigned axis = 2;
  bool is_less(PointId p, PointId q) const { return table_.compare_lexicographically(p, q) == Sign::negative; }
  bool is_in_circle_by_tie(PointId a, PointId b, PointId c, PointId d) const;

  const Constructions& table_;
};

}  // namespace quoin
