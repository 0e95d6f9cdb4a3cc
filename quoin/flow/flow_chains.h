// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/flow_complex.h"

namespace quoin {

/// Critical points of all indices, and which stable manifold bounds which, modulo 2.
struct FlowChains {
  /// By index: the critical faces' numbers, ascending.
  std::array<std::vector<std::uint32_t>, 4> cells;
  /// Of the cell at place i of index k: places among those of index k - 1 in its boundary, ascending. Empty for k = 0.
  std::array<std::vector<std::vector<std::uint32_t>>, 4> boundaries;
  /// Critical polygons one of whose sides flows to infinity, modulo 2, by places.
  std::vector<std::uint32_t> bounds_infinity;

  // Places among the critical polygons with what does not happen in general position. Their boundaries are parts of
  // what they should be, and chains with them need not be a complex.
  std::vector<std::uint32_t> surfaces_not_ordinary;
  std::vector<std::uint32_t> arcs_not_ordinary;  ///< that end in another saddle or passed a regular point

  bool is_ordinary() const { return surfaces_not_ordinary.empty() && arcs_not_ordinary.empty(); }
};

/// Boundaries by stable surfaces of index 2 (backwards) and arcs from there to maxima (forwards).
/// @throws Cancelled
FlowChains flow_chains(const FlowComplex& flow, const Context& context);

/// Whether boundaries of boundaries are empty. Always so where the chains are ordinary.
bool is_chain_complex(const FlowChains& chains);

/// Betti numbers modulo 2 of the chains up to a squared distance, or of all of them: those of the union of balls of
/// that squared radius. The chains must be a complex. By elimination: O(n^3) at worst for n critical points.
std::array<std::size_t, 4> flow_betti_numbers(const FlowComplex& flow, const FlowChains& chains,
                                              const Rational* most = nullptr);

}  // namespace quoin
