// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/arrangement/curve_family.h"
#include "quoin/base/id.h"

namespace quoin {

/// An input curve: all pieces that came of it.
using CurveId = Id<struct CurveTag>;

/// An x-monotone piece of an input curve; its ends are indices into the points of its list.
struct Piece {
  BranchId branch;
  std::uint32_t left = 0;   ///< lexicographically smaller end
  std::uint32_t right = 0;  ///< lexicographically larger end
  CurveId curve;
  bool reversed = false;  ///< the input curve runs from right to left here
};

/// A point that belongs to an input curve (a degenerate one, or a point given as such).
struct LonePoint {
  std::uint32_t point = 0;
  CurveId curve;
};

/// Input curves, cut into x-monotone pieces, ready for the sweep. Points may repeat.
template <class F>
struct PieceList {
  std::vector<typename F::Point> points;
  std::vector<Piece> pieces;
  std::vector<LonePoint> lone_points;
  std::uint32_t curve_count = 0;

  std::uint32_t add_point(const typename F::Point& point) {
    points.push_back(point);
    return static_cast<std::uint32_t>(points.size() - 1);
  }
};

}  // namespace quoin
