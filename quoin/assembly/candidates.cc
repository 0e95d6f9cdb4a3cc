// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/candidates.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace quoin {

namespace {

Integer size_of(const SphereDirection& d) {
  return abs(d.integer(0)) + abs(d.integer(1)) + abs(d.integer(2));
}

/// By the sum of magnitudes; of equal ones the greater components first, z before y and x: upward before all others.
bool is_simpler(const SphereDirection& a, const SphereDirection& b) {
  const std::strong_ordering by_size = size_of(a) <=> size_of(b);
  if (by_size != 0) return by_size < 0;
  for (const std::size_t axis : {2U, 1U, 0U}) {
    const std::strong_ordering here = a.integer(axis) <=> b.integer(axis);
    if (here != 0) return here > 0;
  }
  return false;
}

void sort_and_merge(std::vector<SphereDirection>& directions) {
  std::ranges::sort(directions, is_simpler);
  directions.erase(std::unique(directions.begin(), directions.end(), are_equal), directions.end());
}

}  // namespace

BlockingGraph blocking_graph(const PairRegions& pairs, const RegionDirection& direction, const PartSet& within) {
  BlockingGraph graph(pairs.part_count);
  for (const PartPair& pair : pairs.pairs) {
    if (!within.contains(pair.first) || !within.contains(pair.second)) continue;
    graph.set_arc(pair.first, pair.second, pairs.is_blocked(pair.first, pair.second, direction));
    graph.set_arc(pair.second, pair.first, pairs.is_blocked(pair.second, pair.first, direction));
  }
  return graph;
}

Candidates candidates_in(const PairRegions& pairs, std::vector<SphereDirection> directions, const Context& context) {
  sort_and_merge(directions);
  const PartSet everything = PartSet::all(pairs.part_count);
  Candidates result;
  for (SphereDirection& direction : directions) {
    context.poll();
    BlockingGraph graph = blocking_graph(pairs, direction, everything);
    result.list.push_back({std::move(direction), std::move(graph)});
  }
  return result;
}

Candidates contact_candidates(const PairRegions& pairs, std::size_t most, const Context& context) {
  std::vector<SphereDirection> directions;
  const auto add = [&](const SphereDirection& d) {
    directions.push_back(d);
    directions.push_back(-d);
  };
  for (std::int64_t axis = 0; axis < 3; ++axis) {
    add(std::array<std::int64_t, 3>{axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0});
  }
  const auto keep_simplest = [&] {
    sort_and_merge(directions);
    if (directions.size() > most)
      directions.erase(directions.begin() + static_cast<std::ptrdiff_t>(most), directions.end());
  };
  for (const PartPair& pair : pairs.pairs) {
    context.poll();
    for (const ConvexRegion& region : pair.contacts) {
      for (const RegionDirection& normal : region.normals) add(normal.exact());
      for (const RegionDirection& corner : region.corners) add(corner.exact());
    }
    if (directions.size() > 16 * most) keep_simplest();
  }
  keep_simplest();
  return candidates_in(pairs, std::move(directions), context);
}

Candidates vertex_candidates(const MotionSpace& space, std::size_t most, const Context& context) {
  const dcel::Dcel& cells = space.arrangement().cells();
  std::map<std::vector<std::uint64_t>, std::pair<SphereDirection, BlockingGraph>> found;
  bool are_too_many = false;
  const bool has_vertices = space.counts().vertices > 0;
  space.walk(
      [&](MotionCell cell, const BlockingGraph& graph) {
        if (are_too_many || (has_vertices && cell.kind == MotionCell::Kind::face)) return;
        if (cell.kind == MotionCell::Kind::edge && has_vertices) {
          // Only circles without a vertex add something.
          const dcel::HalfedgeId h(dcel::EdgeId(std::size_t{cell.id}), false);
          if (!space.is_cut(cells.origin(h)) || !space.is_cut(cells.target(h))) return;
        }
        SphereDirection direction = space.direction_in(cell);
        const auto [at, is_new] = found.try_emplace(graph.rows(), direction, graph);
        if (!is_new && is_simpler(direction, at->second.first)) at->second.first = std::move(direction);
        are_too_many = found.size() > most;
      },
      context);
  Candidates result;
  if (are_too_many) return result;
  for (auto& [rows, candidate] : found)
    result.list.push_back({std::move(candidate.first), std::move(candidate.second)});
  std::ranges::sort(result.list,
                    [](const Candidate& a, const Candidate& b) { return is_simpler(a.direction, b.direction); });
  result.are_all = true;
  return result;
}

}  // namespace quoin
