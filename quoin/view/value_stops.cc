// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/value_stops.h"

#include <algorithm>
#include <numeric>

namespace quoin {

ValueStops::ValueStops(std::uint32_t grades, std::uint32_t most, std::span<const std::uint32_t> wanted) {
  if (grades <= most) {
    grade_.resize(grades);
    std::iota(grade_.begin(), grade_.end(), 0U);
    return;
  }
  std::vector<bool> is_stop(grades, false);
  is_stop[grades - 1] = true;
  for (std::uint64_t i = 0; i < most; ++i) is_stop[i * grades / most] = true;
  for (const std::uint32_t grade : wanted) {
    if (grade < grades) is_stop[grade] = true;
  }
  stop_.resize(grades);
  for (std::uint32_t g = 0; g < grades; ++g) {
    stop_[g] = count();
    if (is_stop[g]) grade_.push_back(g);
  }
}

}  // namespace quoin
