// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/ordered_boundaries.h"

#include "quoin/base/error.h"
#include "quoin/base/polled_resize.h"

namespace quoin {

namespace {

constexpr std::size_t poll_interval = 4096;

}  // namespace

OrderedBoundaries::OrderedBoundaries(const SimplicialComplex& complex,
                                     const std::vector<std::vector<std::uint32_t>>& order, const Context& context)
    : facets_(order.size()) {
  LargeVector<std::uint32_t> rank_below;
  for (int k = 0; k <= complex.dimension(); ++k) {
    count_.push_back(order[k].size());
    if (k > 0) {
      resize_and_poll(facets_[k], complex.facets(k).size(), context);
      std::uint32_t* next = facets_[k].data();
      for (std::size_t rank = 0; rank < order[k].size(); ++rank) {
        if (rank % poll_interval == 0) context.poll();
        for (const std::uint32_t facet : complex.facets({k, order[k][rank]})) *next++ = rank_below[facet];
      }
    }
    rank_below.clear();
    resize_and_poll(rank_below, order[k].size(), context);
    for (std::uint32_t rank = 0; rank < order[k].size(); ++rank) {
      if (rank % poll_interval == 0) context.poll();
      rank_below[order[k][rank]] = rank;
    }
  }
}

CoboundaryColumns::CoboundaryColumns(const OrderedBoundaries& boundaries, int k, const Context& context)
    : rows_(boundaries.count(k + 1)) {
  resize_and_poll(begin_, boundaries.count(k) + 1, context);
  if (rows_ == 0) return;
  if (rows_ >= std::size_t{1} << 31) throw InputError("more than 2^31 simplices of one dimension");
  const LargeVector<std::uint32_t>& facets = boundaries.facets(k + 1);
  const auto width = static_cast<std::uint32_t>(k + 2);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (i % poll_interval == 0) context.poll();
    ++begin_[facets[i] + 1];
  }
  for (std::size_t i = 1; i < begin_.size(); ++i) {
    if (i % poll_interval == 0) context.poll();
    begin_[i] += begin_[i - 1];
  }
  resize_and_poll(cofacets_, facets.size(), context);
  LargeVector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  std::size_t i = 0;
  for (std::uint32_t rank = 0; rank < rows_; ++rank) {
    if (rank % poll_interval == 0) context.poll();
    for (std::uint32_t j = 0; j < width; ++j) cofacets_[next[facets[i++]]++] = 2 * rank + j % 2;
  }
}

}  // namespace quoin
