// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/arrangement/arrangement.h"

namespace quoin {

/// Several arrangements drawn over one another.
///
/// The curves of the history are edges of the sources, counted over all of them, never reversed.
template <CurveFamily F>
struct Superposition {
  Arrangement<F> arrangement;
  std::vector<std::uint32_t> first_edge;         ///< by source, and the number of all
  std::vector<std::uint32_t> first_vertex;       ///< by source, and the number of all
  std::vector<dcel::VertexId> vertex_of_source;  ///< by source vertex, counted over all; none for fictitious ones

  struct SourceEdge {
    std::uint32_t source;
    dcel::EdgeId edge;
  };
  SourceEdge source_of(CurveUse use) const {
    const std::uint32_t global = use.curve().value;
    const auto above = std::upper_bound(first_edge.begin(), first_edge.end(), global);
    const auto source = static_cast<std::uint32_t>(above - first_edge.begin() - 1);
    return {source, dcel::EdgeId(std::size_t{global - first_edge[source]})};
  }
};

/// One sweep over the edges of all sources; edges of one source are never intersected with one another.
/// O((n + k) log n) for n source edges and k edges of the result. @throws Cancelled
template <CurveFamily F>
Superposition<F> superpose(std::span<const Arrangement<F>* const> sources, const Context& context);

}  // namespace quoin
