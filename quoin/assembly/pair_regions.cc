// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/pair_regions.h"

#include <algorithm>
#include <map>
#include <utility>

#include "quoin/assembly/box_bounds.h"
#include "quoin/assembly/stopwatch.h"
#include "quoin/base/parallel.h"
#include "quoin/polytope/minkowski_sum.h"

namespace quoin {

namespace {

/// From so many pairs of pieces on, a test of boxes is worth it.
constexpr std::size_t pieces_worth_bounds = 4;

/// What the projections of one pair of parts come to.
struct PairResult {
  SumCounts counts;
  PhaseTimes times;
  bool overlaps = false;
};

void count(OriginPlace place, SumCounts& counts) {
  if (place == OriginPlace::facet) counts.facet += 2;
  if (place == OriginPlace::edge) counts.edge += 2;
  if (place == OriginPlace::vertex) counts.vertex += 2;
  if (place == OriginPlace::separated) counts.separated += 2;
}

PairResult project_pair(const AssemblyPart& first, const AssemblyPart& second, PartPair& pair, const Context& context) {
  PairResult result;
  if (first.pieces.size() * second.pieces.size() >= pieces_worth_bounds)
    pair.bounds = project_boxes(first.box, second.box, context);
  for (std::size_t k = 0; k < second.pieces.size(); ++k) {
    for (std::size_t l = 0; l < first.pieces.size(); ++l) {
      context.poll();
      Stopwatch watch;
      if (are_surely_covered(first.piece_boxes[l], second.piece_boxes[k], pair.pieces)) {
        count(OriginPlace::separated, result.counts);
        result.times.projections += watch.lap();
        continue;
      }
      const Polytope& p = second.pieces[k];
      const Polytope& q = first.reflected[l];
      const PolytopeSum sum = minkowski_sum(p, q, context);
      result.times.sums += watch.lap();
      Projection projection = project(sum, p, q);
      result.times.projections += watch.lap();
      if (projection.place == OriginPlace::inside) {
        result.overlaps = true;
        return result;
      }
      count(projection.place, result.counts);
      if (projection.place != OriginPlace::separated) pair.contacts.push_back(projection.region);
      pair.pieces.push_back(std::move(projection.region));
    }
  }
  return result;
}

void add(const SumCounts& counts, SumCounts& total) {
  total.facet += counts.facet;
  total.edge += counts.edge;
  total.vertex += counts.vertex;
  total.separated += counts.separated;
}

/// Regions by content, each with its number.
using RegionNumbers = std::map<BlockedRegion, std::size_t>;

std::size_t number_of(BlockedRegion region, RegionNumbers& numbers, std::vector<RegionGroup>& groups) {
  const auto [at, is_new] = numbers.try_emplace(region, groups.size());
  if (is_new) groups.push_back({std::move(region), {}});
  return at->second;
}

}  // namespace

bool PairRegions::is_blocked(std::uint32_t moving, std::uint32_t other, const RegionDirection& direction) const {
  const bool is_first = moving < other;
  const PartPair& both = is_first ? pair(moving, other) : pair(other, moving);
  const RegionDirection relative = is_first ? direction : -direction;
  if (both.bounds && !both.bounds->contains(relative)) return false;
  return std::ranges::any_of(both.pieces, [&](const ConvexRegion& region) { return region.contains(relative); });
}

PairRegions project_pairs(std::span<const AssemblyPart> parts, std::vector<OverlappingParts>& overlaps,
                          PhaseTimes& times, const Context& context) {
  PairRegions all;
  all.part_count = parts.size();
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    for (std::uint32_t j = i + 1; j < parts.size(); ++j) all.pairs.push_back({i, j, {}, {}, {}});
  }
  std::vector<PairResult> results(all.pairs.size());
  constexpr std::size_t pairs_at_once = 64;
  for (std::size_t done = 0; done < all.pairs.size(); done += pairs_at_once) {
    context.progress("sums of pairs", static_cast<double>(done) / static_cast<double>(all.pairs.size()));
    const std::size_t count = std::min(pairs_at_once, all.pairs.size() - done);
    for_each_chunk(context, count, 1, [&](const Chunk& chunk) {
      for (std::size_t k = done + chunk.begin; k < done + chunk.end; ++k) {
        PartPair& pair = all.pairs[k];
        results[k] = project_pair(parts[pair.first], parts[pair.second], pair, context);
      }
    });
  }
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (results[k].overlaps) overlaps.push_back({all.pairs[k].first, all.pairs[k].second});
    add(results[k].counts, all.counts);
    times.sums += results[k].times.sums;
    times.projections += results[k].times.projections;
  }
  return all;
}

std::vector<RegionGroup> unite_pairs(const PairRegions& pairs, MotionKind kind, PhaseTimes& times,
                                     const Context& context, const PairFilter& counts) {
  const auto is_counted = [&](std::uint32_t i, std::uint32_t j) { return !counts || counts(i, j); };
  Stopwatch watch;
  std::vector<BlockedRegion> united(pairs.pairs.size());
  const std::size_t grain = 16;
  for (std::size_t done = 0; done < united.size(); done += 8 * grain) {
    context.progress("unions of pairs", static_cast<double>(done) / static_cast<double>(united.size()));
    for_each_chunk(context, std::min(8 * grain, united.size() - done), grain, [&](const Chunk& chunk) {
      for (std::size_t k = done + chunk.begin; k < done + chunk.end; ++k) {
        const PartPair& pair = pairs.pairs[k];
        if (!is_counted(pair.first, pair.second) && !is_counted(pair.second, pair.first)) continue;
        united[k] = unite(kind == MotionKind::infinite ? pair.pieces : pair.contacts, context);
      }
    });
  }
  RegionNumbers numbers;
  std::vector<RegionGroup> groups;
  std::map<BlockedRegion, std::size_t> opposite;  // groups of reflected regions, by region
  const auto number_of_opposite = [&](const BlockedRegion& region) {
    const auto known = opposite.find(region);
    if (known != opposite.end()) return known->second;
    return opposite.emplace(region, number_of(reflected(region), numbers, groups)).first->second;
  };
  for (std::size_t k = 0; k < united.size(); ++k) {
    const auto [i, j] = std::pair(pairs.pairs[k].first, pairs.pairs[k].second);
    const BlockedRegion& region = united[k];
    if (region.arcs.empty() && region.vertices.empty() && !region.blocks_elsewhere) continue;
    if (is_counted(i, j)) groups[number_of(region, numbers, groups)].arcs.push_back({i, j});
    if (is_counted(j, i)) groups[number_of_opposite(region)].arcs.push_back({j, i});
  }
  times.unions += watch.lap();
  return groups;
}

}  // namespace quoin
