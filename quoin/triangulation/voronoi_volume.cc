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

/// A cell by the vectors to its other vertices, so ordered that their determinant is positive.
struct Corner {
  std::array<std::uint32_t, 3> vertices{};
  std::array<std::uint32_t, 3> mates{};  ///< the cells opposite
  Vector numerator;                      ///< 2 `determinant` times the circumcentre
  Integer determinant;
};

class CellVolume {
 public:
  CellVolume(const Delaunay3& triangulation, std::uint32_t vertex, std::span<const std::uint32_t> star)
      : triangulation_(triangulation), vertex_(vertex) {
    find_vectors(star);
    for (const std::uint32_t c : star) {
      place_.emplace(c, corners_.size());
      corners_.push_back(corner(c));
    }
  }

  Rational run() const {
    Integer product(1);
    for (const Corner& corner : corners_) product *= corner.determinant;
    Integer sum;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Corner& corner = corners_[i];
      const Integer others = exact_quotient(product, corner.determinant);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t j = place_.at(corner.mates[k]);
        if (j < i) continue;
        const Vector way = vector(corner.vertices[(k + 2) % 3]) - vector(corner.vertices[(k + 1) % 3]);
        const Integer term = dot(way, cross(corner.numerator, corners_[j].numerator));
        if (term.sign() != Sign::zero) sum += term * exact_quotient(others, corners_[j].determinant);
      }
    }
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
  void find_vectors(std::span<const std::uint32_t> star) {
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t c : star) {
      for (const std::uint32_t v : triangulation_.cells()[c].vertices) vertices.push_back(v);
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::vector<double> values;
    for (const std::uint32_t v : vertices) {
      const Point3& p = triangulation_.point(v);
      values.insert(values.end(), {p.x, p.y, p.z});
    }
    lo_ = detail::CallGrid(values).lo;
    const auto on_grid = [&](std::uint32_t v) {
      const Point3& p = triangulation_.point(v);
      return Vector{detail::on_grid(p.x, lo_), detail::on_grid(p.y, lo_), detail::on_grid(p.z, lo_)};
    };
    const Vector origin = on_grid(vertex_);
    for (const std::uint32_t v : vertices) vectors_.emplace(v, on_grid(v) - origin);
  }

  const Vector& vector(std::uint32_t v) const { return vectors_.at(v); }

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
    const Vector& first = vector(result.vertices[0]);
    result.determinant = dot(first, cross(vector(result.vertices[1]), vector(result.vertices[2])));
    if (result.determinant.sign() == Sign::negative) {
      std::swap(result.vertices[1], result.vertices[2]);
      std::swap(result.mates[1], result.mates[2]);
      result.determinant = -result.determinant;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector& a = vector(result.vertices[k]);
      const Integer square = dot(a, a);
      const Vector normal = cross(vector(result.vertices[(k + 1) % 3]), vector(result.vertices[(k + 2) % 3]));
      for (std::size_t axis = 0; axis < 3; ++axis) result.numerator[axis] += square * normal[axis];
    }
    return result;
  }

  const Delaunay3& triangulation_;
  std::uint32_t vertex_;
  int lo_ = 0;
  std::unordered_map<std::uint32_t, Vector> vectors_;     ///< from the vertex, by those at its cells
  std::unordered_map<std::uint32_t, std::size_t> place_;  ///< of a cell among the corners
  std::vector<Corner> corners_;
};

}  // namespace

Rational voronoi_volume(const Delaunay3& triangulation, std::uint32_t vertex, std::span<const std::uint32_t> star) {
  return CellVolume(triangulation, vertex, star).run();
}

}  // namespace quoin
