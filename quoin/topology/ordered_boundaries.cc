// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/ordered_boundaries.h"

#include "quoin/base/error.h"

namespace quoin {

OrderedBoundaries::OrderedBoundaries(const SimplicialComplex& complex,
                                     const std::vector<std::vector<std::uint32_t>>& order)
    : facets_(order.size()) {
  LargeVector<std::uint32_t> rank_below;
  for (int k = 0; k <= complex.dimension(); ++k) {
    count_.push_back(order[k].size());
    if (k > 0) {
      facets_[k].resize(complex.facets(k).size());
      std::uint32_t* next = facets_[k].data();
      for (const std::uint32_t simplex : order[k])
        for (const std::uint32_t facet : complex.facets({k, simplex})) *next++ = rank_below[facet];
    }
    rank_below.resize(order[k].size());
    for (std::uint32_t rank = 0; rank < order[k].size(); ++rank) rank_below[order[k][rank]] = rank;
  }
}

CoboundaryColumns::CoboundaryColumns(const OrderedBoundaries& boundaries, int k)
    : rows_(boundaries.count(k + 1)), begin_(boundaries.count(k) + 1, 0) {
  if (rows_ == 0) return;
  if (rows_ >= std::size_t{1} << 31) throw InputError("more than 2^31 simplices of one dimension");
  const LargeVector<std::uint32_t>& facets = boundaries.facets(k + 1);
  const auto width = static_cast<std::uint32_t>(k + 2);
  for (const std::uint32_t facet : facets) ++begin_[facet + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  cofacets_.resize(facets.size());
  LargeVector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  std::size_t i = 0;
  for (std::uint32_t rank = 0; rank < rows_; ++rank)
    for (std::uint32_t j = 0; j < width; ++j) cofacets_[next[facets[i++]]++] = 2 * rank + j % 2;
}

}  // namespace quoin
