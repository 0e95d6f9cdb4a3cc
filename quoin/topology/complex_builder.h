// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/large_vector.h"
#include "quoin/topology/simplex_list.h"
#include "quoin/topology/simplicial_complex.h"

namespace quoin {

/// Makes the closure of a list of simplices, dimension by dimension from the highest, and knows where each was listed.
///
/// Rows of one dimension, vertices and place in the list, are sorted by their first vertex in buckets, then within
/// these; facets are looked up, and those that are missing are added to the next dimension before it is used.
class ComplexBuilder {
 public:
  ComplexBuilder(const SimplexList& simplices, const Context& context);

  static constexpr std::uint32_t not_listed = 0xFFFFFFFFU;

  SimplicialComplex build();

  /// After `build`: by dimension and simplex the first place in the list, or `not_listed`; and pairs of places that
  /// have the same vertices.
  std::vector<std::vector<std::uint32_t>>& listing() { return listing_; }
  const std::vector<std::array<std::uint32_t, 2>>& duplicates() const { return duplicates_; }

 private:
  using Rows = LargeVector<std::uint32_t>;

  void require_valid() const;
  void number_vertices();
  void spread_rows();
  void finish_layer(int k);
  Rows sort_by_first(const Rows& rows, std::size_t width, std::vector<std::size_t>& begin) const;
  void sort_rows(int k, Rows rows);
  Rows join_facets(int k);

  const SimplexList& simplices_;
  const Context& context_;
  SimplicialComplex result_;
  std::vector<Rows> given_;  // rows of each dimension: vertices in ascending order, then the place in the list
  std::vector<std::vector<std::uint32_t>> listing_;
  std::vector<std::array<std::uint32_t, 2>> duplicates_;
};

}  // namespace quoin
