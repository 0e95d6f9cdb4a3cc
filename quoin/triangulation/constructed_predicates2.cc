// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/constructed_predicates2.h"

#include "quoin/triangulation/tie_rule2.h"

namespace quoin {

bool ConstructedPredicates2::in_conflict(const TriangleLinks2& t, PointId d) const {
  const auto infinite = static_cast<std::uint32_t>(table_.point_count());
  for (unsigned slot = 0; slot < 3; ++slot) {
    if (t.corner[slot] != infinite) continue;
    const std::uint32_t from = t.corner[next_slot(slot)];
    const std::uint32_t to = t.corner[previous_slot(slot)];
    const Sign side = turn(from, to, d);
    if (side != Sign::zero) return side == Sign::positive;
    return is_less(point(from), d) == is_less(d, point(to));
  }
  const PointId a = point(t.corner[0]);
  const PointId b = point(t.corner[1]);
  const PointId c = point(t.corner[2]);
  const Sign side = table_.in_circle(a, b, c, d, axis);
  return side == Sign::zero ? is_in_circle_by_tie(a, b, c, d) : side == Sign::positive;
}

bool ConstructedPredicates2::is_in_circle_by_tie(PointId a, PointId b, PointId c, PointId d) const {
  return detail::is_in_circle_when_lifted<PointId>(
      {a, b, c}, d, [this](PointId p, PointId q) { return is_less(p, q); },
      [this](PointId p, PointId q, PointId r) { return table_.turn_any(p, q, r, axis); });
}

}  // namespace quoin
