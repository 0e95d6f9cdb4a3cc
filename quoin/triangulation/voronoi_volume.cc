// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/voronoi_volume.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <unordered_map>
#include <utility>
#include <vector>

#include "quoin/triangulation/circulators.h"
#include "quoin/triangulation/grid_integers.h"

namespace quoin {

namespace {

using Vector = std::array<Integer, 3>;

Integer dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// b divides a.
Integer exact_quotient(const Integer& a, const Integer& b) {
  Integer result;
  mpz_divexact(result.raw(), a.raw(), b.raw());
  return result;
}

/// A vertex beside the one whose cell is measured.
struct Neighbour {
  Vector way;      ///< to it
  Integer square;  ///< of the way, less what it weighs more
};

/// A cell by the vectors to its other vertices, so ordered that their determinant is positive.
struct Corner {
  std::array<std::uint32_t, 3> vertices{};
  std::array<std::uint32_t, 3> mates{};  ///< the cells opposite
  Vector numerator;                      ///< 2 `determinant` times the circumcentre
  Integer determinant;
};

class CellVolume {
 public:
  CellVolume(const TriangulationView3& triangulation, std::uint32_t vertex, std::span<const std::uint32_t> star)
      : triangulation_(triangulation), vertex_(vertex) {
    find_neighbours(star);
    for (const std::uint32_t c : star) {
      place_.emplace(c, corners_.size());
      corners_.push_back(corner(c));
    }
  }

  Rational run() const {
    Integer product(1);
    for (const Corner& corner : corners_) product *= corner.determinant;
    Integer sum = is_weighted_ ? sum_of_facets(product) : sum_of_edges(product);
    // A grid of 2^lo: its cube.
    product *= Integer(48);
    const std::size_t shift = std::size_t{3} * static_cast<std::size_t>(std::abs(lo_));
    if (lo_ < 0) {
      product <<= shift;
    } else {
      sum <<= shift;
    }
    return {sum, product};
  }

 private:
  /// Calls `visit(others, corner, next, from, to)` for each edge of the cell, where `others` is the product of all
  /// determinants but that of the first corner. The facet to `to` has it in this direction, seen from outside; that to
  /// `from` the other way round.
  template <class Visit>
  void for_each_edge(const Integer& product, const Visit& visit) const {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Corner& corner = corners_[i];
      const Integer others = exact_quotient(product, corner.determinant);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t j = place_.at(corner.mates[k]);
        if (j > i) visit(others, corner, corners_[j], corner.vertices[(k + 1) % 3], corner.vertices[(k + 2) % 3]);
      }
    }
  }

  Integer sum_of_edges(const Integer& product) const {
    Integer sum;
    for_each_edge(product, [&](const Integer& others, const Corner& corner, const Corner& next, std::uint32_t from,
                               std::uint32_t to) {
      const Integer term = dot(way(to) - way(from), cross(corner.numerator, next.numerator));
      if (term.sign() != Sign::zero) sum += term * exact_quotient(others, next.determinant);
    });
    return sum;
  }

  /// Multiplies the product by the coordinates that the facets' sums are divided by.
  Integer sum_of_facets(Integer& product) const {
    std::unordered_map<std::uint32_t, Integer> facets;
    for_each_edge(product, [&](const Integer& others, const Corner& corner, const Corner& next, std::uint32_t from,
                               std::uint32_t to) {
      const Vector normal = cross(corner.numerator, next.numerator);
      const Integer factor = exact_quotient(others, next.determinant);
      facets[to] += normal[axis_of(to)] * factor;
      facets[from] -= normal[axis_of(from)] * factor;
    });
    Integer divisors(1);
    for (const auto& [v, area] : facets) divisors *= way(v)[axis_of(v)];
    Integer sum;
    for (const auto& [v, area] : facets) {
      sum += area * neighbours_.at(v).square * exact_quotient(divisors, way(v)[axis_of(v)]);
    }
    product *= divisors;
    return sum;
  }

  std::size_t axis_of(std::uint32_t v) const {
    std::size_t axis = 0;
    while (way(v)[axis].sign() == Sign::zero) ++axis;
    return axis;
  }

  void find_neighbours(std::span<const std::uint32_t> star) {
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t c : star) {
      for (const std::uint32_t v : triangulation_.cells()[c].vertices) vertices.push_back(v);
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::vector<Point3> points;
    std::vector<double> weights;  // if any differs from the vertex's
    for (const std::uint32_t v : vertices) {
      points.push_back(triangulation_.point(v));
      is_weighted_ |= triangulation_.weight(v) != triangulation_.weight(vertex_);
    }
    if (is_weighted_) {
      for (const std::uint32_t v : vertices) weights.push_back(triangulation_.weight(v));
    }
    lo_ = detail::grid_of_weighted(points, weights);
    const auto on_grid = [&](std::uint32_t v) {
      const Point3& p = triangulation_.point(v);
      return Vector{detail::on_grid(p.x, lo_), detail::on_grid(p.y, lo_), detail::on_grid(p.z, lo_)};
    };
    const auto weight = [&](std::uint32_t v) { return detail::on_grid(triangulation_.weight(v), 2 * lo_); };
    const Vector origin = on_grid(vertex_);
    for (const std::uint32_t v : vertices) {
      Neighbour neighbour{on_grid(v) - origin, {}};
      neighbour.square = dot(neighbour.way, neighbour.way);
      if (is_weighted_) neighbour.square -= weight(v) - weight(vertex_);
      neighbours_.emplace(v, std::move(neighbour));
    }
  }

  const Vector& way(std::uint32_t v) const { return neighbours_.at(v).way; }

  Corner corner(std::uint32_t c) const {
    const TriangulationCell& cell = triangulation_.cells()[c];
    Corner result;
    const unsigned apex = slot_of(cell, vertex_);
    for (unsigned i = 0, k = 0; i < 4; ++i) {
      if (i == apex) continue;
      result.vertices[k] = cell.vertices[i];
      result.mates[k] = cell.neighbours[i] >> 2;
      ++k;
    }
    result.determinant = dot(way(result.vertices[0]), cross(way(result.vertices[1]), way(result.vertices[2])));
    if (result.determinant.sign() == Sign::negative) {
      std::swap(result.vertices[1], result.vertices[2]);
      std::swap(result.mates[1], result.mates[2]);
      result.determinant = -result.determinant;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Integer& square = neighbours_.at(result.vertices[k]).square;
      const Vector normal = cross(way(result.vertices[(k + 1) % 3]), way(result.vertices[(k + 2) % 3]));
      for (std::size_t axis = 0; axis < 3; ++axis) result.numerator[axis] += square * normal[axis];
    }
    return result;
  }

  const TriangulationView3& triangulation_;
  std::uint32_t vertex_;
  int lo_ = 0;
  bool is_weighted_ = false;
  std::unordered_map<std::uint32_t, Neighbour> neighbours_;  ///< by vertices at its cells, itself among them
  std::unordered_map<std::uint32_t, std::size_t> place_;     ///< of a cell among the corners
  std::vector<Corner> corners_;
};

}  // namespace

Rational voronoi_volume(const TriangulationView3& triangulation, std::uint32_t vertex,
                        std::span<const std::uint32_t> star) {
  return CellVolume(triangulation, vertex, star).run();
}

}  // namespace quoin
