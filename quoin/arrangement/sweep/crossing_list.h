// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/arrangement/curve_family.h"
#include "quoin/arrangement/pieces.h"
#include "quoin/base/context.h"

namespace quoin {

/// Two pieces of a list that meet in a point inside both.
struct PiecePair {
  std::uint32_t one = 0;
  std::uint32_t two = 0;
  bool crosses = true;  ///< they change their order there; false where they only touch
};

/// Where pairs of pieces meet, one entry for each pair and point, in any order.
template <class Point>
struct CrossingList {
  std::vector<Point> points;
  std::vector<PiecePair> pairs;

  void add(const Point& point, const PiecePair& pair) {
    points.push_back(point);
    pairs.push_back(pair);
  }
};

/// A family that finds all crossings of a list by trying pairs, which costs less than finding them along a sweep where
/// many pairs meet: no crossing is sought twice, and no queue of them is kept.
///
/// find_crossings appends every point that lies inside two pieces, strictly between the ends of both. It returns false,
/// with the list in any state, where pieces overlap, where it cannot quickly exclude that (one curve was given twice),
/// or where so few pairs meet that the sweep finds them faster; which depends on the input alone.
template <class F>
concept PairwiseFamily = CurveFamily<F> &&
    requires(const F& f, const PieceList<F>& list, const Context& context, CrossingList<typename F::Point>& out) {
  { f.find_crossings(list, context, out) } -> std::same_as<bool>;
};

}  // namespace quoin
