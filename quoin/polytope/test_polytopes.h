// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/polytope/polytope.h"

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

/// The same with two vertices as poles; rounded, and yet its own mirror image in the plane y = 0.
inline Points icosahedron_on_its_pole() {
  Points points{{0, 0, 1}, {0, 0, -1}};
  const double r = 2 / std::sqrt(5.0);
  for (int i = 0; i <= 5; ++i) {
    const double angle = 3.14159265358979323846 / 5 * i;
    const double z = (i % 2 == 0 ? 1 : -1) / std::sqrt(5.0);
    const double y = i == 0 || i == 5 ? 0 : r * std::sin(angle);
    for (const int side : {-1, 1}) points.push_back({r * std::cos(angle), side * y, z});
  }
  return points;
}

/// Over a polygon of sixteen sides.
inline Points pyramid() {
  Points points{{0, -20, 0}};
  for (const auto& [x, z] : {std::pair{20, 0}, {18, 8}, {14, 14}, {8, 18}, {0, 20}}) {
    for (const int s : {-1, 1}) {
      for (const int t : {-1, 1}) points.push_back({double(s * x), 0, double(t * z)});
    }
  }
  return points;
}

/// Rings of vertices, each from its least on.
using Rings = std::set<std::vector<std::uint32_t>>;

inline Rings rings_of(std::vector<std::vector<std::uint32_t>> facets) {
  Rings rings;
  for (std::vector<std::uint32_t>& facet : facets) {
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
    rings.insert(std::move(facet));
  }
  return rings;
}

inline Rings rings_of(const Polytope& p) {
  std::vector<std::vector<std::uint32_t>> facets;
  for (std::uint32_t f = 0; f < p.facet_count(); ++f) {
    std::vector<std::uint32_t>& facet = facets.emplace_back();
    std::uint32_t h = p.first_halfedge(f);
    do {
      facet.push_back(p.halfedges()[h].tail);
      h = p.halfedges()[h].next;
    } while (h != p.first_halfedge(f));
  }
  return rings_of(std::move(facets));
}

}  // namespace quoin::test_polytopes
