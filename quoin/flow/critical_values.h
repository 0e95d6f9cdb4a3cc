// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "quoin/flow/flow_cells.h"
#include "quoin/number/interval.h"
#include "quoin/number/rational.h"

namespace quoin {

/// Squared distances at critical points named by simplices: bounds, and exact.
class CriticalValues {
 public:
  explicit CriticalValues(const Delaunay3& triangulation) : triangulation_(triangulation) {}

  Interval of_edge(std::uint32_t cell, unsigned edge) const;
  Interval of_facet(CellFacet facet) const;
  Interval of_cell(std::uint32_t cell) const;
  Rational exactly_of_edge(std::uint32_t cell, unsigned edge) const;
  Rational exactly_of_facet(CellFacet facet) const;
  Rational exactly_of_cell(std::uint32_t cell) const;

 private:
  Point3 corner(std::uint32_t cell, unsigned slot) const {
    return triangulation_.point(triangulation_.cells()[cell].vertices[slot]);
  }
  const Delaunay3& triangulation_;
};

/// Whether the distances at two points, given squared, differ by at most `most`, which is not negative: high - low <=
/// most. Exact.
bool differ_by_at_most(const Rational& square_low, const Rational& square_high, const Rational& most);

}  // namespace quoin
