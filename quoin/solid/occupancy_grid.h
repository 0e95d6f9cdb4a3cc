// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quoin/solid/float_box.h"

namespace quoin {

/// Which of 64^3 equal cells of a box are met by the boxes added to it: a quick and certain "no" for boxes that meet
/// none of them.
class OccupancyGrid {
 public:
  /// Cells divide lo x, y, z, hi x, y, z; boxes added must lie within.
  explicit OccupancyGrid(const std::array<float, 6>& bounds);

  /// Returns the number of rows of cells touched, at least 1: what it cost.
  std::size_t add(const FloatBox& box);
  /// False only if the box meets no added box.
  bool may_meet(const FloatBox& box) const;

 private:
  static constexpr std::uint32_t cells = 64;
  struct Range {
    std::array<std::uint32_t, 3> first;
    std::array<std::uint32_t, 3> last;
    std::uint64_t row_bits() const { return (~std::uint64_t{0} << first[0]) & (~std::uint64_t{0} >> (63 - last[0])); }
  };

  Range range(const FloatBox& box) const;
  std::uint32_t cell(float x, std::size_t axis) const;

  FloatBox bounds_;
  std::array<float, 3> scale_;
  std::vector<std::uint64_t> rows_;  // a bit per cell along x, by z and y
};

}  // namespace quoin
