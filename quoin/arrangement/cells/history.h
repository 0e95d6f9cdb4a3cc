// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/arrangement/cells/dcel.h"
#include "quoin/arrangement/pieces.h"

namespace quoin {

/// An input curve that passes along an edge, and which way. There are at most 2^30 curves.
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
  friend class CurveHistory;
  static constexpr std::uint32_t bundle_flag = 0x80000000U;
  static constexpr CurveUse bundle_number(std::size_t bundle) {
    CurveUse use;
    use.value_ = bundle_flag | static_cast<std::uint32_t>(bundle);
    return use;
  }
  constexpr bool is_bundle() const { return value_ >= bundle_flag; }
  constexpr std::uint32_t bundle() const { return value_ & ~bundle_flag; }

  std::uint32_t value_ = 0xFFFFFFFFU;
};

/// Which input curves induce each edge: one in place, several in a shared table.
class CurveHistory {
 public:
  std::size_t edge_count() const { return uses_.size(); }
  std::span<const CurveUse> of(dcel::EdgeId edge) const {
    const CurveUse& use = uses_[edge.index()];
    if (!use.is_bundle()) return {&use, 1};
    const std::uint32_t bundle = use.bundle();
    return {table_.data() + bundle_begin_[bundle], bundle_begin_[bundle + 1] - bundle_begin_[bundle]};
  }
  /// Edges of each curve, in the order of edges. O(size).
  std::vector<std::vector<dcel::EdgeId>> edges_by_curve(std::size_t curve_count) const;

  void reserve(std::size_t edges) { uses_.reserve(edges); }
  /// The next edge has these curves. An edge without curves is allowed (fictitious ones).
  void append(std::span<const CurveUse> curves) { uses_.push_back(stored(curves)); }
  void append_single(CurveUse curve) { uses_.push_back(curve); }
  void assign(dcel::EdgeId edge, std::span<const CurveUse> curves);

 private:
  CurveUse stored(std::span<const CurveUse> curves) { return curves.size() == 1 ? curves[0] : stored_bundle(curves); }
  CurveUse stored_bundle(std::span<const CurveUse> curves);

  std::vector<CurveUse> uses_;  // by edge: a curve, or the number of a bundle
  std::vector<CurveUse> table_;
  std::vector<std::uint32_t> bundle_begin_{0};
};

}  // namespace quoin
