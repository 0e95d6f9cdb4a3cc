// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "quoin/base/sign.h"
#include "quoin/triangulation/delaunay3.h"

namespace quoin {

/// What the shape of one simplex of a triangulation of space says of its circumcentre and of the angles of its facets.
struct CellShape {
  std::uint8_t centre = 0;  ///< for each slot two bits: 1 + the sign of the circumcentre against the facet opposite
  /// For each slot two bits: the slot of the corner of the facet opposite that is not acute; the slot itself if there
  /// is none.
  std::uint8_t corner = 0;
  std::uint8_t right = 0;  ///< for each slot a bit: that corner is a right angle

  Sign centre_sign(unsigned facet) const { return static_cast<Sign>(static_cast<int>(centre >> 2 * facet & 3) - 1); }
  unsigned wide_corner(unsigned facet) const { return corner >> 2 * facet & 3U; }
  bool is_right(unsigned facet) const { return (right >> facet & 1) != 0; }
  bool is_acute(unsigned facet) const { return wide_corner(facet) == facet; }
  /// The corner that is obtuse; the facet's own slot if there is none.
  unsigned obtuse_corner(unsigned facet) const { return is_right(facet) ? facet : wide_corner(facet); }
};

/// How many signs doubles did not decide.
struct CellSignCounts {
  std::size_t centres = 0;
  std::size_t spheres = 0;
};

/// Shapes of the simplices of a triangulation, and whether neighbours are cospherical. Exact. Doubles with derived
/// bounds; where points are on a grid, integers of 128 bits; else rationals.
class CellSigns {
 public:
  /// O(n). The triangulation must be of dimension 3 and outlive it.
  explicit CellSigns(const Delaunay3& triangulation);

  /// Of a simplex that is no ghost; `spheres` gets for each slot in `tested` a bit: whether the vertex of the neighbour
  /// there is on its sphere.
  CellShape shape(std::uint32_t cell, unsigned tested, unsigned& spheres);

  const CellSignCounts& undecided() const { return undecided_; }

 private:
  using Corners = std::array<const Point3*, 4>;
  /// Given the squared distances of the other corners from the first.
  void set_corners(const Corners& p, const std::array<double, 3>& from_first, CellShape& shape) const;
  unsigned close_corner(const Corners& p, unsigned facet, unsigned widest, bool& is_right) const;
  bool is_on_grid(double m) const { return m <= largest_exact_; }
  Sign exact_centre_sign(const Corners& p, unsigned facet, double m);
  bool is_exactly_on_sphere(std::uint32_t cell, const Corners& p, std::uint32_t vertex, double m);

  std::span<const TriangulationCell> cells_;
  const Delaunay3& triangulation_;
  DelaunaySigns signs_;
  const Point3* points_;
  bool are_squares_exact_ = false;  ///< of differences, in doubles
  double to_grid_ = 0;              ///< makes coordinates integers
  double largest_exact_ = -1;       ///< differences up to it fit the integers
  CellSignCounts undecided_;
};

}  // namespace quoin
