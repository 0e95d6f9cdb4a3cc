// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "random.h"

/// Which points come and go in changing_bench and its peer: some of `count`, each once, in a random order, the same on
/// every platform.
inline std::vector<std::size_t> changing_order(std::size_t count, std::size_t changes) {
  Random random(5);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  changes = std::min(changes, count);
  for (std::size_t i = 0; i < changes; ++i) std::swap(order[i], order[i + random.bits() % (count - i)]);
  order.resize(changes);
  return order;
}
