// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "quoin/base/parallel.h"

namespace quoin {

/// Below this many elements one thread sorts.
constexpr std::size_t sort_grain = 8192;

/// Sorts halves at the same time, and merges them from both ends at once. `less` must be an order in which only
/// identical elements are equivalent: then the result does not depend on the number of threads.
///
/// Each half may take another level of `depth`. O(n log n), and memory for another copy.
template <class T, class Less = std::less<T>>
void sort_parallel(const Context& context, std::span<T> list, const Less& less = {}, unsigned depth = 2) {
  context.poll();
  if (context.threads() <= 1 || list.size() < sort_grain || depth == 0) {
    std::sort(list.begin(), list.end(), less);
    return;
  }
  const std::size_t half = list.size() / 2;
  const std::span<T> low = list.first(half);
  const std::span<T> high = list.subspan(half);
  run_both(
      context, [&] { sort_parallel(context, low, less, depth - 1); },
      [&] { sort_parallel(context, high, less, depth - 1); });
  // The merged list splits at `half` where the low half gives `taken` elements and the high half the rest.
  std::size_t taken = 0;
  for (std::size_t step = half; step > 0;) {
    const std::size_t i = taken + step;
    // One more from the low half belongs to the first part while it comes before what the high half would give.
    if (i <= half && (i == 0 || half - i >= high.size() || !less(high[half - i], low[i - 1]))) {
      taken = i;
    } else {
      step /= 2;
    }
  }
  std::vector<T> merged(list.size());
  const auto low_middle = low.begin() + static_cast<std::ptrdiff_t>(taken);
  const auto high_middle = high.begin() + static_cast<std::ptrdiff_t>(half - taken);
  const auto middle = merged.begin() + static_cast<std::ptrdiff_t>(half);
  run_both(
      context, [&] { std::merge(low.begin(), low_middle, high.begin(), high_middle, merged.begin(), less); },
      [&] { std::merge(low_middle, low.end(), high_middle, high.end(), middle, less); });
  std::copy(merged.begin(), merged.end(), list.begin());
}

template <class T, class Less = std::less<T>>
void sort_parallel(const Context& context, std::vector<T>& list, const Less& less = {}) {
  sort_parallel(context, std::span<T>(list), less);
}

}  // namespace quoin
