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
/// For each slot two bits, the lowest ones for slot 0.
struct CellShape {
  std::uint8_t centre = 0;  ///< 1 + the sign of the circumcentre against the facet opposite
  /// The slot of the corner of the facet opposite that is not acute; the slot itself if there is none.
  std::uint8_t corner = 0;
  std::uint8_t right = 0;  ///< 1 if that corner is a right angle

  Sign centre_sign(unsigned facet) const { return static_cast<Sign>(static_cast<int>(centre >> 2 * facet & 3) - 1); }
  unsigned wide_corner(unsigned facet) const { return corner >> 2 * facet & 3U; }
  bool is_right(unsigned facet) const { return (right >> 2 * facet & 1) != 0; }
  /// The corner that is obtuse; the facet's own slot if there is none.
  unsigned obtuse_corner(unsigned facet) const { return is_right(facet) ? facet : wide_corner(facet); }

  // The same of all facets at once: for each slot the lower one of its two bits.
  unsigned wide() const {
    const unsigned differs = corner ^ own_slots;
    return (differs | differs >> 1) & lower_bits;
  }
  unsigned obtuse() const { return wide() & ~static_cast<unsigned>(right); }
  unsigned centre_positive() const { return centre >> 1 & lower_bits; }
  unsigned centre_zero() const { return centre & lower_bits; }
  unsigned centre_negative() const { return ~(centre_positive() | centre_zero()) & lower_bits; }

 private:
  static constexpr unsigned own_slots = 0xE4;  ///< 0, 1, 2, 3
  static constexpr unsigned lower_bits = 0x55;
};

/// How many signs doubles did not decide, of how many.
struct CellSignCounts {
  std::size_t centres = 0;
  std::size_t spheres = 0;
  std::size_t centre_calls = 0;
  std::size_t sphere_calls = 0;
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
