// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <utility>

#include "quoin/base/sign.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin::detail {

/// The rule for ties on the circle of a triangle: whether d is in it once each of the four is lifted by an
/// infinitesimal, far larger for larger points. The lift with the largest effect that is not zero decides: that of d
/// takes d out, that of a corner takes it in exactly when d is on the corner's side of the line through the other two.
///
/// `turn(p, q, d)` is exact, `is_less` the lexicographic order. The largest corner decides unless d is on the line
/// through two others, as it may be in a power circle.
/// Source: Devillers and Teillaud 2011, and predicates of perturbed heights in general.
template <class Point, class Less, class Turn>
bool is_in_circle_when_lifted(const std::array<Point, 3>& t, const Point& d, const Less& is_less, const Turn& turn) {
  std::array<unsigned, 3> order{0, 1, 2};
  for (unsigned k = 0; k < 3; ++k) {
    for (unsigned j = k + 1; j < 3; ++j) {
      if (is_less(t[order[k]], t[order[j]])) std::swap(order[k], order[j]);
    }
    const unsigned largest = order[k];
    if (is_less(t[largest], d)) return false;
    const Sign effect = turn(t[next_slot(largest)], t[previous_slot(largest)], d);
    if (effect != Sign::zero) return effect == Sign::positive;
  }
  return false;
}

}  // namespace quoin::detail
