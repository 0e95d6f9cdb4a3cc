// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/flow/face_formulas.h"
#include "quoin/flow/flow_cells.h"

namespace quoin {

/// For each vertex the pole, the farthest Voronoi vertex of its cell: of points that sample a surface densely, it is
/// near the medial axis, and the way to it is nearly a normal.
///
/// Exact. Of equally far ones the lexicographically largest. A vertex of the hull has none; its direction is the sum of
/// the vector areas of the polygons of the hull at it. Source: Amenta and Bern 1999.
class Poles {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  /// O(n) for n simplices. The cells must outlive it. @throws Cancelled
  Poles(const FlowCells& flow, const Context& context);

  /// A simplex whose circumcentre is the pole, or none.
  std::uint32_t cell(std::uint32_t vertex) const { return cell_[vertex]; }

  /// From the vertex towards the pole, or away from the hull, or the opposite of that; of any length, in intervals or
  /// rationals.
  template <class N>
  flow::Vector<N> direction(std::uint32_t vertex) const;

 private:
  const FlowCells& flow_;
  std::vector<std::uint32_t> cell_;
  std::vector<std::uint64_t> hull_;  ///< of each corner of a hull polygon the vertex, and what names it; ascending
};

}  // namespace quoin
