// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "quoin/triangulation/regular_predicates2.h"
#include "quoin/triangulation/test_points2.h"

/// Weighted points of the plane for tests: weights of many kinds for the points of test_points2.h.
namespace quoin::testing {

using Weighted = std::vector<WeightedPoint2>;

inline std::string reproduce(const Weighted& points) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const auto& [p, w] : points) out << "{{" << p.x << ", " << p.y << "}, " << w << "}, ";
  return out.str();
}

struct PlaneWeightFamily {
  const char* name;
  double (*weight)(Random&);
};

inline const std::vector<PlaneWeightFamily>& plane_weight_families() {
  static const std::vector<PlaneWeightFamily> all{
      {"small integers", [](Random& r) { return small_integer(r, 3); }},
      {"a few large ones", [](Random& r) { return r() % 8 == 0 ? 50.0 * unit(r) : 0.0; }},
      {"fractions", [](Random& r) { return 0.1 * unit(r); }},
      {"any doubles", [](Random& r) { return any_finite(r); }},
  };
  return all;
}

inline Weighted weigh(Random& random, const std::vector<Point2>& points, const PlaneWeightFamily& family) {
  Weighted result;
  for (const Point2& p : points) result.push_back({p, family.weight(random)});
  return result;
}

}  // namespace quoin::testing
