// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/large_vector.h"
#include "quoin/topology/simplicial_complex.h"

namespace quoin {

/// The boundaries of the simplices of a complex, by their ranks in an order of each dimension.
class OrderedBoundaries {
 public:
  /// `order[k][r]` is the simplex of rank r among those of dimension k.
  OrderedBoundaries(const SimplicialComplex& complex, const std::vector<std::vector<std::uint32_t>>& order,
                    const Context& context);

  int dimension() const { return static_cast<int>(count_.size()) - 1; }
  std::size_t count(int k) const { return k < 0 || k > dimension() ? 0 : count_[k]; }
  /// Ranks of the facets of all simplices of dimension k > 0 by their ranks, k + 1 for each, signs alternating.
  const LargeVector<std::uint32_t>& facets(int k) const { return facets_[k]; }

 private:
  std::vector<std::size_t> count_;
  std::vector<LargeVector<std::uint32_t>> facets_;
};

/// Columns are boundaries of simplices of dimension k, rows those of dimension k - 1 that are not left out.
class BoundaryColumns {
 public:
  /// `left_out`: null, or the rows that cannot be pivots. Both arguments are kept by reference.
  explicit BoundaryColumns(const OrderedBoundaries& boundaries, int k, const std::vector<bool>* left_out = nullptr)
      : facets_(boundaries.facets(k)),
        left_out_(left_out),
        width_(static_cast<std::size_t>(k) + 1),
        rows_(boundaries.count(k - 1)),
        columns_(boundaries.count(k)) {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }

  template <class Call>
  void for_each(std::uint32_t column, const Call& call) const {
    const std::uint32_t* facet = facets_.data() + column * width_;
    for (std::size_t j = 0; j < width_; ++j)
      if (left_out_ == nullptr || !(*left_out_)[facet[j]]) call(facet[j], j % 2 == 0 ? 1 : -1);
  }

 private:
  const LargeVector<std::uint32_t>& facets_;
  const std::vector<bool>* left_out_;
  std::size_t width_;
  std::size_t rows_;
  std::size_t columns_;
};

/// Columns are coboundaries of simplices of dimension k, in reverse order as their rows, those of dimension k + 1, are.
class CoboundaryColumns {
 public:
  CoboundaryColumns(const OrderedBoundaries& boundaries, int k, const Context& context);

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return begin_.size() - 1; }
  /// Of the simplex of this rank among those of dimension k, and the other way about.
  std::uint32_t column_of(std::uint32_t rank) const { return static_cast<std::uint32_t>(columns() - 1 - rank); }
  std::uint32_t row_of(std::uint32_t rank) const { return static_cast<std::uint32_t>(rows_ - 1 - rank); }

  template <class Call>
  void for_each(std::uint32_t column, const Call& call) const {
    const std::uint32_t rank = column_of(column);
    for (std::size_t i = begin_[rank]; i < begin_[rank + 1]; ++i)
      call(row_of(cofacets_[i] >> 1), (cofacets_[i] & 1) == 0 ? 1 : -1);
  }

 private:
  std::size_t rows_;
  LargeVector<std::size_t> begin_;
  LargeVector<std::uint32_t> cofacets_;  // twice the rank, and 1 if the sign is negative
};

}  // namespace quoin
