// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/arrangement/dcel.h"
#include "quoin/arrangement/pieces.h"

namespace quoin {

/// An input curve that passes along an edge, and which way.
class CurveUse {
 public:
  constexpr CurveUse() = default;
  constexpr CurveUse(CurveId curve, bool reversed) : value_(2 * curve.value + static_cast<std::uint32_t>(reversed)) {}

  constexpr CurveId curve() const { return CurveId(std::size_t{value_ / 2}); }
  /// The curve runs from the right end of the edge to the left one.
  constexpr bool is_reversed() const { return (value_ & 1U) != 0; }
  friend constexpr bool operator==(CurveUse, CurveUse) = default;
  friend constexpr auto operator<=>(CurveUse, CurveUse) = default;

 private:
  std::uint32_t value_ = 0xFFFFFFFFU;
};

/// Which input curves induce each edge: one in place, several in a shared table.
class CurveHistory {
 public:
  std::size_t edge_count() const { return uses_.size(); }
  std::span<const CurveUse> of(dcel::EdgeId edge) const {
    const Use& use = uses_[edge.index()];
    if (use.bundle == single) return {&use.curve, 1};
    return {table_.data() + use.bundle, use.count};
  }
  /// Edges of each curve, in the order of edges. O(size).
  std::vector<std::vector<dcel::EdgeId>> edges_by_curve(std::size_t curve_count) const;

  /// The next edge has these curves. An edge without curves is allowed (fictitious ones).
  void append(std::span<const CurveUse> curves);
  void assign(dcel::EdgeId edge, std::span<const CurveUse> curves);

 private:
  static constexpr std::uint32_t single = 0xFFFFFFFFU;
  struct Use {
    CurveUse curve;
    std::uint32_t bundle = single;
    std::uint32_t count = 1;
  };
  Use stored(std::span<const CurveUse> curves);

  std::vector<Use> uses_;
  std::vector<CurveUse> table_;
};

}  // namespace quoin
