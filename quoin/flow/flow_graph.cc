// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_graph.h"

#include <algorithm>
#include <numeric>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/error.h"
#include "quoin/flow/critical_spheres.h"
#include "quoin/triangulation/exact_ranks.h"

namespace quoin {

FlowGraph::FlowGraph(const FlowCells& flow, const Context& context) : flow_(flow), values_(flow.triangulation()) {
  for (std::uint32_t c = 0; c < flow.cells().size(); ++c) {
    if (c % 1024 == 0) context.poll();
    if (flow.is_ghost(c) || flow.first_of(c) != c || flow.way(c).kind != CellWay::Kind::maximum) continue;
    maxima_.push_back({c, values_.of_cell(c)});
  }
  SaddleArcs arcs(flow);
  flow.for_each_saddle(context, [&](CellFacet facet) {
    const std::array<SaddleEnd, 2> ends = arcs.ends(facet, context);
    for (const SaddleEnd& end : ends) passed_ += end.has_passed_regular ? 1 : 0;
    saddles_.push_back(
        {facet, {place(ends[0], arcs, context), place(ends[1], arcs, context)}, values_.of_facet(facet)});
  });
}

std::uint32_t FlowGraph::place(SaddleEnd end, SaddleArcs& arcs, const Context& context) {
  in_saddles_ += end.kind == SaddleEnd::Kind::saddle ? 1 : 0;
  while (end.kind == SaddleEnd::Kind::saddle) end = arcs.end(end.cell, context);
  if (end.kind == SaddleEnd::Kind::infinity) return infinity();
  const auto found = std::lower_bound(maxima_.begin(), maxima_.end(), end.cell,
                                      [](const Maximum& m, std::uint32_t cell) { return m.cell < cell; });
  return static_cast<std::uint32_t>(found - maxima_.begin());
}

namespace {

/// What `face(i)` has, by ascending squares, given bounds; ties by number.
template <class Face>
ExactRanks ranks_of(std::span<const Interval> bounds, const CriticalSpheres& spheres, const Face& face,
                    const Context& context) {
  const NumberSource source{[&](std::uint32_t i) { return spheres.close_square(face(i)); },
                            [&](std::uint32_t i) { return spheres.exact_square(face(i)); }};
  return exact_ranks(bounds, source, context);
}

template <class Things>
std::vector<Interval> squares_of(const Things& things) {
  std::vector<Interval> squares;
  squares.reserve(things.size());
  for (const auto& thing : things) squares.push_back(thing.square);
  return squares;
}

}  // namespace

std::vector<FlowGraph::Pair> FlowGraph::pairs(const Context& context) const {
  const CriticalSpheres spheres(flow_.triangulation());
  const std::vector<std::uint32_t> by_height =
      ranks_of(
          squares_of(maxima_), spheres,
          [this](std::uint32_t i) { return CriticalFace::simplex(flow_, maxima_[i].cell); }, context)
          .order();
  std::vector<std::uint32_t> rank(maxima_.size() + 1, infinity());
  for (std::uint32_t i = 0; i < by_height.size(); ++i) rank[by_height[i]] = i;
  const std::vector<std::uint32_t> order =
      ranks_of(
          squares_of(saddles_), spheres,
          [this](std::uint32_t i) { return CriticalFace::facet(flow_, saddles_[i].facet); }, context)
          .order();
  DisjointSets regions(maxima_.size() + 1);
  std::vector<std::uint32_t> highest(maxima_.size() + 1);
  std::iota(highest.begin(), highest.end(), 0U);
  std::vector<Pair> pairs;
  for (std::size_t i = order.size(); i > 0; --i) {
    if (i % 1024 == 0) context.poll();
    const Saddle& saddle = saddles_[order[i - 1]];
    std::uint32_t low = highest[regions.find(saddle.ends[0])];
    std::uint32_t high = highest[regions.find(saddle.ends[1])];
    if (low == high) continue;
    if (rank[low] > rank[high]) std::swap(low, high);
    pairs.push_back({order[i - 1], low, high});
    regions.unite(low, high);
    highest[regions.find(low)] = high;
  }
  return pairs;
}

bool FlowGraph::is_shallow(const Pair& pair, const Rational& most) const {
  const Interval around = Interval::around(most);
  const Interval& low = saddles_[pair.saddle].square;
  const Interval& high = maxima_[pair.maximum].square;
  const Interval difference = square_root(high) - square_root(low);
  if (difference.upper() <= around.lower()) return true;
  if (difference.lower() > around.upper()) return false;
  return differ_by_at_most(exact_square_of_saddle(pair.saddle), exact_square_of_maximum(pair.maximum), most);
}

std::vector<std::uint32_t> FlowGraph::simplified(const Rational& most, const Context& context) const {
  if (most.sign() == Sign::negative) throw InputError("a difference of distances must not be negative");
  std::vector<std::uint32_t> becomes(maxima_.size() + 1);
  std::iota(becomes.begin(), becomes.end(), 0U);
  for (const Pair& pair : pairs(context)) {
    if (is_shallow(pair, most)) becomes[pair.maximum] = pair.behind;
  }
  context.poll();
  // What a maximum becomes is higher, so chains end; each is shortened as it is followed.
  for (std::uint32_t i = 0; i < becomes.size(); ++i) {
    while (becomes[becomes[i]] != becomes[i]) becomes[i] = becomes[becomes[i]];
  }
  becomes.pop_back();
  return becomes;
}

std::vector<std::uint32_t> FlowGraph::saddles_up_to(const Rational& square, const Context& context) const {
  const Interval around = Interval::around(square);
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < saddles_.size(); ++i) {
    if (i % 256 == 0) context.poll();
    const auto exact = [&] { return exact_square_of_saddle(i); };
    if (is_at_most(saddles_[i].square, exact, square, around)) found.push_back(i);
  }
  return found;
}

std::array<std::size_t, 4> FlowGraph::counts(const Rational& square, const Context& context) const {
  const Interval around = Interval::around(square);
  std::array<std::size_t, 4> counts{};
  if (square.sign() != Sign::negative) counts[0] = flow_.counts()[0];
  flow_.for_each_critical_edge(context, [&](std::uint32_t cell, unsigned edge) {
    const auto exact = [&] { return values_.exactly_of_edge(cell, edge); };
    counts[1] += is_at_most(values_.of_edge(cell, edge), exact, square, around) ? 1 : 0;
  });
  counts[2] = saddles_up_to(square, context).size();
  for (std::uint32_t i = 0; i < maxima_.size(); ++i) {
    const auto exact = [&] { return exact_square_of_maximum(i); };
    counts[3] += is_at_most(maxima_[i].square, exact, square, around) ? 1 : 0;
  }
  return counts;
}

// What is farther from the points than the radius falls into as many parts as there are hollows, and the outside.
std::array<std::size_t, 3> FlowGraph::betti_numbers(const Rational& square, const Context& context) const {
  if (square.sign() == Sign::negative) return {};
  const Interval around = Interval::around(square);
  DisjointSets components(flow_.counts()[0]);
  std::size_t component_count = flow_.counts()[0];
  flow_.for_each_critical_edge(context, [&](std::uint32_t cell, unsigned edge) {
    const auto exact = [&] { return values_.exactly_of_edge(cell, edge); };
    if (!is_at_most(values_.of_edge(cell, edge), exact, square, around)) return;
    const std::uint32_t a = components.find(flow_.cells()[cell].vertices[edge_slots[edge][0]]);
    const std::uint32_t b = components.find(flow_.cells()[cell].vertices[edge_slots[edge][1]]);
    if (a == b) return;
    components.unite(a, b);
    --component_count;
  });
  const std::array<std::size_t, 4> below = counts(square, context);
  std::size_t hollows = maxima_.size() - below[3];
  DisjointSets parts(maxima_.size() + 1);
  for (std::uint32_t i = 0; i < saddles_.size(); ++i) {
    const auto exact = [&] { return exact_square_of_saddle(i); };
    if (is_at_most(saddles_[i].square, exact, square, around)) continue;
    const std::uint32_t a = parts.find(saddles_[i].ends[0]);
    const std::uint32_t b = parts.find(saddles_[i].ends[1]);
    if (a == b) continue;
    parts.unite(a, b);
    --hollows;
  }
  return {component_count, component_count + hollows + below[1] + below[3] - below[0] - below[2], hollows};
}

}  // namespace quoin
