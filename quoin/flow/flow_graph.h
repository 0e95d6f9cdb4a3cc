// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/critical_values.h"
#include "quoin/flow/saddle_arcs.h"

namespace quoin {

/// Maxima of the distance, joined by the ways from saddles of index 2 between them. Infinity is one more place behind
/// them, higher than all.
class FlowGraph {
 public:
  struct Maximum {
    std::uint32_t cell;  ///< that names it
    Interval square;     ///< of the distance there
  };
  struct Saddle {
    CellFacet facet;  ///< that names it
    /// Places of maxima, or of infinity; the first on the side of the facet's simplex.
    std::array<std::uint32_t, 2> ends;
    Interval square;
  };
  /// A maximum that appears as a hollow of the growing union of balls closes when the hollow fills, and the saddle at
  /// which the hollow was cut off from what is higher.
  struct Pair {
    std::uint32_t saddle;
    std::uint32_t maximum;
    std::uint32_t behind;  ///< the highest maximum, or infinity, of the region that it was cut off from
  };

  /// By the arcs of all saddles: O(n), as in SaddleArcs. Ways that end in a saddle are followed on from it. The cells
  /// must outlive it. @throws Cancelled
  FlowGraph(const FlowCells& flow, const Context& context);

  std::span<const Maximum> maxima() const { return maxima_; }
  std::span<const Saddle> saddles() const { return saddles_; }
  std::uint32_t infinity() const { return static_cast<std::uint32_t>(maxima_.size()); }
  /// How many ways of saddles passed a stationary point that is not critical, or ended in another saddle.
  std::size_t passed_count() const { return passed_; }
  std::size_t in_saddle_count() const { return in_saddles_; }

  const FlowCells& cells() const { return flow_; }
  Rational exact_square_of_maximum(std::uint32_t i) const { return values_.exactly_of_cell(maxima_[i].cell); }
  Rational exact_square_of_saddle(std::uint32_t i) const { return values_.exactly_of_facet(saddles_[i].facet); }

  /// Each maximum with its saddle, by descending saddles; exact order, ties by numbers. Saddles that are left over cut
  /// no hollow off. O(n log n) comparisons. @throws Cancelled
  std::vector<Pair> pairs(const Context& context) const;

  /// Whether the distances of a pair differ by at most this much. Exact.
  bool is_shallow(const Pair& pair, const Rational& most) const;

  /// What the cancellation of shallow pairs leaves: for each maximum, the one that its region becomes a part of, itself
  /// if it stays, or infinity. @throws InputError if `most` is negative; Cancelled
  std::vector<std::uint32_t> simplified(const Rational& most, const Context& context) const;

  /// Betti numbers of the union of balls of this squared radius, which those of the points up to it are homotopy
  /// equivalent to: components by critical edges, hollows by saddles above, tunnels by the alternating sum. Exact.
  /// O(n). @throws Cancelled
  std::array<std::size_t, 3> betti_numbers(const Rational& square, const Context& context) const;
  /// Places of saddles up to a squared distance. @throws Cancelled
  std::vector<std::uint32_t> saddles_up_to(const Rational& square, const Context& context) const;
  /// Critical points up to a squared distance, by index. @throws Cancelled
  std::array<std::size_t, 4> counts(const Rational& square, const Context& context) const;

 private:
  std::uint32_t place(SaddleEnd end, SaddleArcs& arcs, const Context& context);

  const FlowCells& flow_;
  CriticalValues values_;
  std::vector<Maximum> maxima_;
  std::vector<Saddle> saddles_;
  std::size_t passed_ = 0;
  std::size_t in_saddles_ = 0;
};

}  // namespace quoin
