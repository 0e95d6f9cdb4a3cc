// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"

/// What tests of polytopes share.
namespace quoin::test_polytopes {

using Random = std::mt19937_64;
using Points = std::vector<Point3>;

inline const Context one_thread({.threads = 1});

/// At least 0 and below `end`.
inline int below(Random& random, int end) {
  return static_cast<int>(random() % static_cast<std::uint64_t>(end));
}

/// From `least` to `least + more - 1` points of a small grid, of which many coincide or lie in one plane.
inline Points on_a_small_grid(Random& random, int least, int more) {
  const int size = 2 + below(random, 5);
  Points points;
  for (int i = least + below(random, more); i > 0; --i) {
    const double x = below(random, size);
    const double y = below(random, size);
    points.push_back({x, y, double(below(random, size))});
  }
  return points;
}

/// (0, +-5, +-8) and the like: 20 facets, nearly regular.
inline Points icosahedron() {
  Points points;
  for (const double a : {-5.0, 5.0}) {
    for (const double b : {-8.0, 8.0}) {
      points.push_back({0, a, b});
      points.push_back({b, 0, a});
      points.push_back({a, b, 0});
    }
  }
  return points;
}

}  // namespace quoin::test_polytopes
