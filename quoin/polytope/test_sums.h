// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <ostream>
#include <set>
#include <span>
#include <vector>

#include "quoin/polytope/hull.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/test_polytopes.h"

/// Sums compared with hulls, by the coordinates of their cells, where these are doubles.
namespace quoin::test_polytopes {

using Corner = std::array<double, 3>;

struct Cells {
  int dimension = 0;
  std::set<Corner> vertices;
  std::set<std::vector<Corner>> facets;  ///< from the smallest corner on
  friend bool operator==(const Cells&, const Cells&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Cells& cells) {
    out << "dimension " << cells.dimension << ", " << cells.vertices.size() << " vertices, facets";
    for (const std::vector<Corner>& facet : cells.facets) {
      out << " [";
      for (const auto& [x, y, z] : facet) out << "(" << x << " " << y << " " << z << ")";
      out << "]";
    }
    return out;
  }
};

inline Corner corner_of(const Point3& p) {
  return {p.x + 0.0, p.y + 0.0, p.z + 0.0};
}

template <class Rings>
std::set<std::vector<Corner>> facets_of(const Rings& rings, const Points& points) {
  std::set<std::vector<Corner>> facets;
  for (std::size_t f = 0; f < rings.facet_count(); ++f) {
    std::vector<Corner> facet;
    for (const std::uint32_t v : rings.facet(f)) facet.push_back(corner_of(points[v]));
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
    facets.insert(facet);
  }
  return facets;
}

inline Cells cells_of_hull(const Points& points) {
  const ConvexHull hull = convex_hull(points, one_thread);
  Cells cells{hull.dimension, {}, facets_of(hull, points)};
  for (const std::uint32_t v : hull.vertices) cells.vertices.insert(corner_of(points[v]));
  return cells;
}

/// `vertices` must be doubles.
inline Cells cells_of_sum(const FacetRings& sum, const std::vector<RationalPoint3>& vertices) {
  Points points;
  for (const RationalPoint3& p : vertices) points.push_back({p.x.to_double(), p.y.to_double(), p.z.to_double()});
  Cells cells{sum.dimension, {}, facets_of(sum, points)};
  for (const Point3& p : points) cells.vertices.insert(corner_of(p));
  return cells;
}

/// All sums of a point of each.
inline Points all_sums(std::span<const Points> summands) {
  Points sums{{0, 0, 0}};
  for (const Points& summand : summands) {
    Points more;
    for (const Point3& p : sums) {
      for (const Point3& q : summand) more.push_back({p.x + q.x, p.y + q.y, p.z + q.z});
    }
    sums = std::move(more);
  }
  return sums;
}

inline Points scaled(Points points, double factor) {
  for (Point3& p : points) p = {p.x * factor, p.y * factor, p.z * factor};
  return points;
}

/// Points of a random flat of the given dimension through a small grid; the hull may be of a lower one.
inline Points on_a_small_flat(Random& random, int dimension) {
  const auto vector = [&] {
    const int x = below(random, 5) - 2;
    const int y = below(random, 5) - 2;
    return Vector3{double(x), double(y), double(below(random, 5) - 2)};
  };
  const std::array<Vector3, 3> along{vector(), vector(), vector()};
  const Vector3 origin = vector();
  Points points;
  for (int i = dimension + 1 + below(random, 1 + 3 * dimension); i > 0; --i) {
    Point3 p{origin.x, origin.y, origin.z};
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
      const int times = below(random, 4);
      p = {p.x + times * along[k].x, p.y + times * along[k].y, p.z + times * along[k].z};
    }
    points.push_back(p);
  }
  return points;
}

inline const Points cube{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                         {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
inline const Points octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
inline const Points tetrahedron{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

struct Counts {
  std::size_t vertices;
  std::size_t edges;
  std::size_t facets;
  friend bool operator==(const Counts&, const Counts&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Counts& c) {
    return out << c.vertices << "/" << c.edges << "/" << c.facets;
  }
};

}  // namespace quoin::test_polytopes
