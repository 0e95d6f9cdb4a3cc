// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iomanip>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "quoin/arrangement/linear/linear_polygon_set.h"

/// Sets that tests of the plane share.
namespace quoin::testing {

using Ring = std::vector<Point2>;
using Rings = std::vector<Ring>;

inline LinearPolygonSet set_of(const Rings& rings, FillRule rule = FillRule::even_odd) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  for (const Ring& ring : rings) family.add_polyline(list, ring, true);
  return combine_rings(std::move(family), list, std::vector<std::uint32_t>(rings.size(), 0), 1, rule,
                       SetOperation::unite, Context());
}

inline Ring box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

/// Rings of 3 corners and fewer than `corners` more on a grid from (base, base): they touch, overlap and cross
/// themselves.
inline Rings random_rings(std::mt19937& random, int rings, int corners, int size, double base = 0) {
  Rings result(static_cast<std::size_t>(rings));
  for (Ring& ring : result) {
    const std::size_t count = 3 + random() % static_cast<unsigned>(corners);
    while (ring.size() < count) {
      const Point2 p{base + static_cast<double>(random() % static_cast<unsigned>(size)),
                     base + static_cast<double>(random() % static_cast<unsigned>(size))};
      if (ring.empty() || (p != ring.back() && p != ring.front())) ring.push_back(p);
    }
  }
  return result;
}

/// Squares of a grid, each there or not: tight everywhere.
inline Rings random_squares(std::mt19937& random, int size) {
  Rings result;
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) {
      if (random() % 3 != 0) result.push_back(box(x, y, 1, 1));
    }
  }
  if (result.empty()) result.push_back(box(0, 0, 1, 1));
  return result;
}

/// What reproduces a failure.
inline std::string written(const Rings& rings) {
  std::ostringstream text;
  for (const Ring& ring : rings) {
    for (const Point2& p : ring) text << std::setprecision(17) << '(' << p.x << ' ' << p.y << ") ";
    text << "; ";
  }
  return text.str();
}

template <class F>
PolygonSet<F> both(const PolygonSet<F>& a, const PolygonSet<F>& b, SetOperation operation,
                   Regularity regularity = Regularity::plain) {
  const std::vector<const PolygonSet<F>*> pair{&a, &b};
  return combine<F>(pair, operation, regularity, Context());
}

inline bool are_equal(const LinearPolygonSet& a, const LinearPolygonSet& b) {
  return both(a, b, SetOperation::symmetric_difference).is_empty();
}

}  // namespace quoin::testing
