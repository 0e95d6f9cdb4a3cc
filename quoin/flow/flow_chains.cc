// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_chains.h"

#include <algorithm>
#include <unordered_map>

#include "quoin/flow/stable_surface.h"
#include "quoin/flow/unstable_arcs.h"

namespace quoin {

namespace {

using Column = std::vector<std::uint32_t>;

/// Sorted, without what is there an even number of times.
void reduce_modulo_2(Column& column) {
  std::sort(column.begin(), column.end());
  Column odd;
  for (const std::uint32_t i : column) {
    if (!odd.empty() && odd.back() == i) {
      odd.pop_back();
    } else {
      odd.push_back(i);
    }
  }
  column = std::move(odd);
}

Column sum(const Column& a, const Column& b) {
  Column both;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

/// Place of a critical face's number; it is among them.
std::uint32_t place(const std::vector<std::uint32_t>& cells, std::uint32_t index) {
  return static_cast<std::uint32_t>(std::lower_bound(cells.begin(), cells.end(), index) - cells.begin());
}

void add_surface(const FlowComplex& flow, FlowChains& chains, std::uint32_t at, const Context& context) {
  const StableSurface surface = stable_surface(flow, chains.cells[2][at], context);
  Column& boundary = chains.boundaries[2][at];
  for (const StableSide& side : surface.sides) boundary.push_back(place(chains.cells[1], side.edge));
  reduce_modulo_2(boundary);
  if (!surface.is_ordinary()) chains.surfaces_not_ordinary.push_back(at);
}

void add_arcs(const FlowComplex& flow, ArcTracer& tracer, FlowChains& chains, std::uint32_t at,
              const Context& context) {
  bool is_ordinary = true;
  unsigned to_infinity = 0;
  for (const UnstableArc& arc : tracer.trace(chains.cells[2][at], context).arcs) {
    is_ordinary &= !arc.has_passed_regular;
    if (arc.is_infinite) {
      ++to_infinity;
    } else if (arc.end.dimension == 3 && flow.is_critical(arc.end)) {
      chains.boundaries[3][place(chains.cells[3], arc.end.index)].push_back(at);
    } else {
      is_ordinary = false;
    }
  }
  if (to_infinity == 1) chains.bounds_infinity.push_back(at);
  if (!is_ordinary) chains.arcs_not_ordinary.push_back(at);
}

}  // namespace

FlowChains flow_chains(const FlowComplex& flow, const Context& context) {
  FlowChains chains;
  for (const DeloneFace& face : flow.faces_of_kind(FlowKind::critical)) {
    chains.cells[face.dimension].push_back(face.index);
  }
  for (std::size_t k = 0; k < 4; ++k) chains.boundaries[k].resize(chains.cells[k].size());
  for (std::uint32_t i = 0; i < chains.cells[1].size(); ++i) {
    const std::array<std::uint32_t, 2> ends = flow.faces().edge(chains.cells[1][i]);
    chains.boundaries[1][i].assign(ends.begin(), ends.end());
  }
  ArcTracer tracer(flow);
  for (std::uint32_t i = 0; i < chains.cells[2].size(); ++i) {
    add_surface(flow, chains, i, context);
    add_arcs(flow, tracer, chains, i, context);
  }
  for (Column& boundary : chains.boundaries[3]) reduce_modulo_2(boundary);
  return chains;
}

bool is_chain_complex(const FlowChains& chains) {
  for (std::size_t k = 2; k < 4; ++k) {
    for (const Column& boundary : chains.boundaries[k]) {
      Column twice;
      for (const std::uint32_t face : boundary) twice = sum(twice, chains.boundaries[k - 1][face]);
      if (!twice.empty()) return false;
    }
  }
  return true;
}

std::array<std::size_t, 4> flow_betti_numbers(const FlowComplex& flow, const FlowChains& chains, const Rational* most) {
  std::array<std::size_t, 4> cells{};
  std::array<std::size_t, 5> ranks{};
  for (unsigned k = 0; k < 4; ++k) {
    std::unordered_map<std::uint32_t, Column> by_last;
    for (std::size_t i = 0; i < chains.cells[k].size(); ++i) {
      if (most != nullptr && flow.square_radius({k, chains.cells[k][i]}) > *most) continue;
      ++cells[k];
      Column column = chains.boundaries[k][i];
      for (auto found = by_last.end(); !column.empty(); column = sum(column, found->second)) {
        found = by_last.find(column.back());
        if (found == by_last.end()) break;
      }
      if (!column.empty()) by_last[column.back()] = std::move(column);
    }
    ranks[k] = by_last.size();
  }
  std::array<std::size_t, 4> betti{};
  for (std::size_t k = 0; k < 4; ++k) betti[k] = cells[k] - ranks[k] - ranks[k + 1];
  return betti;
}

}  // namespace quoin
