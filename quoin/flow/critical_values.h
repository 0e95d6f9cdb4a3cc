// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "quoin/flow/flow_cells.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/number/interval.h"
#include "quoin/number/rational.h"

namespace quoin {

/// Critical points named by simplices: the squared distances there, as bounds and exact, and where they are.
class CriticalValues {
 public:
  explicit CriticalValues(const Delaunay3& triangulation) : triangulation_(triangulation) {}

  Interval of_edge(std::uint32_t cell, unsigned edge) const;
  Interval of_facet(CellFacet facet) const;
  Interval of_cell(std::uint32_t cell) const;
  Rational exactly_of_edge(std::uint32_t cell, unsigned edge) const;
  Rational exactly_of_facet(CellFacet facet) const;
  Rational exactly_of_cell(std::uint32_t cell) const;

  /// The critical points themselves.
  RationalPoint3 midpoint(std::uint32_t cell, unsigned edge) const;
  RationalPoint3 centre(CellFacet facet) const;
  RationalPoint3 centre(std::uint32_t cell) const;

  /// The same within 2^-30 of the largest coordinate of their simplex or their own: nine digits, much quicker.
  Point3 near_midpoint(std::uint32_t cell, unsigned edge) const;
  Point3 near_centre(CellFacet facet) const;
  Point3 near_centre(std::uint32_t cell) const;

 private:
  Point3 corner(std::uint32_t cell, unsigned slot) const {
    return triangulation_.point(triangulation_.cells()[cell].vertices[slot]);
  }
  const Delaunay3& triangulation_;
};

/// Each coordinate the nearest double.
inline Point3 to_nearest_doubles(const RationalPoint3& p) {
  return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}

/// Whether a number is at most another, both with bounds: `exact()` is asked where those overlap.
template <class Exact>
bool is_at_most(const Interval& bounds, const Exact& exact, const Rational& most, const Interval& around) {
  if (bounds.upper() <= around.lower()) return true;
  if (bounds.lower() > around.upper()) return false;
  return exact() <= most;
}

/// Whether the distances at two points, given squared, differ by at most `most`, which is not negative: high - low <=
/// most. Exact.
bool differ_by_at_most(const Rational& square_low, const Rational& square_high, const Rational& most);

}  // namespace quoin
