// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/topology/simplex_list.h"
#include "quoin/topology/simplicial_complex.h"

namespace quoin {

/// Makes the closure of a list of simplices, dimension by dimension from the highest.
///
/// Rows of one dimension are sorted by their first vertex in buckets, then within these; facets are looked up, and
/// those that are missing are added to the next dimension before it is used.
class ComplexBuilder {
 public:
  ComplexBuilder(const SimplexList& simplices, const Context& context);

  SimplicialComplex build();

 private:
  using Rows = std::vector<std::uint32_t>;

  void require_valid() const;
  void number_vertices();
  void spread_rows();
  void finish_layer(int k, Rows rows);
  void sort_rows(int k, Rows& rows);
  Rows join_facets(int k);

  const SimplexList& simplices_;
  const Context& context_;
  SimplicialComplex result_;
  std::vector<Rows> given_;  // rows of each dimension, vertices in ascending order
};

}  // namespace quoin
