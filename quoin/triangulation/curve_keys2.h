// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "quoin/kernel/point.h"

namespace quoin::detail {

// Hilbert's curve four levels at a time. A state is two bits: whether x and y are swapped (1) and both reversed (2);
// at each level the quadrant (x bit, y bit) has a position along the curve and changes the state below it.
struct CurveTable {
  std::array<std::array<std::uint8_t, 256>, 4> key{};
  std::array<std::array<std::uint8_t, 256>, 4> state{};
};

constexpr CurveTable make_curve_table() {
  constexpr std::array<std::array<unsigned, 4>, 4> position{{{0, 1, 3, 2}, {0, 3, 1, 2}, {2, 3, 1, 0}, {2, 1, 3, 0}}};
  constexpr std::array<unsigned, 4> change{1, 0, 0, 3};
  CurveTable table;
  for (unsigned start = 0; start < 4; ++start) {
    for (unsigned xy = 0; xy < 256; ++xy) {
      unsigned state = start;
      unsigned key = 0;
      for (unsigned level = 4; level-- > 0;) {
        const unsigned quadrant = ((xy >> (4 + level)) & 1) * 2 + ((xy >> level) & 1);
        const unsigned place = position[state][quadrant];
        key = key * 4 + place;
        state ^= change[place];
      }
      table.key[start][xy] = static_cast<std::uint8_t>(key);
      table.state[start][xy] = static_cast<std::uint8_t>(state);
    }
  }
  return table;
}

inline constexpr CurveTable curve_table = make_curve_table();

inline std::uint32_t curve_key(unsigned x, unsigned y) {
  unsigned state = 0;
  std::uint32_t key = 0;
  for (unsigned shift = 16; shift > 0;) {
    shift -= 4;
    const unsigned xy = ((x >> shift) & 15) * 16 + ((y >> shift) & 15);
    key = key << 8 | curve_table.key[state][xy];
    state = curve_table.state[state][xy];
  }
  return key;
}

// Coordinates are halved first, so that no difference of finite ones overflows.
class CurveAxis {
 public:
  CurveAxis(double low, double high) : low_(low / 2), high_(high / 2) {
    const double extent = high_ - low_;
    factor_ = extent > 0 ? 65536 / extent : 0;
    if (std::isfinite(factor_)) return;
    // Cells of an extent below 2^-1008 are no doubles: both are scaled.
    scale_ = 0x1p60;
    factor_ = 65536 / (extent * scale_);
  }
  unsigned cell(double x) const {
    const double place = (x / 2 - low_) * scale_ * factor_;
    // Zero times infinity, of the smallest extents, is no number: the first cell too.
    return place > 0 ? static_cast<unsigned>(std::min(place, 65535.0)) : 0;
  }

 private:
  double low_;
  double high_;
  double scale_ = 1;
  double factor_;
};

/// Numbers of cells along Hilbert's curve: 2^16 x 2^16 of a box, for any finite doubles.
class CurveKeys2 {
 public:
  CurveKeys2(const Point2& low, const Point2& high) : x_(low.x, high.x), y_(low.y, high.y) {}
  std::uint32_t operator()(const Point2& p) const { return curve_key(x_.cell(p.x), y_.cell(p.y)); }

 private:
  CurveAxis x_;
  CurveAxis y_;
};

}  // namespace quoin::detail
