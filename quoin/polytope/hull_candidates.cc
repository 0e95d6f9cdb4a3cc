// SPDX-License-Identifier: Apache-2.0
//
// Few of the points, evenly chosen, have a hull, which tells which of 16 times as many may be corners; the hull of
// those tells of again 16 times as many, and in the end of all. Where points fill a body, what is left falls with the
// root of their number, so that all these hulls are small.
#include "quoin/polytope/hull_candidates.h"

#include <algorithm>
#include <optional>

#include "quoin/base/parallel.h"
#include "quoin/polytope/hull_filter.h"
#include "quoin/polytope/hull_of_some.h"
#include "quoin/polytope/hull_reach.h"

namespace quoin {

namespace {

constexpr std::uint32_t many_points = 1000;
constexpr std::uint32_t very_many_points = 30000;  // enough to pay for a table
constexpr std::uint32_t few_points = 256;
constexpr std::size_t most_points = 65536;  // that a hull is made of, to tell about others
constexpr std::size_t grain = 65536;

/// From each step-th point to each of 16 times as many; to all, if that is not many more.
std::uint32_t finer(std::uint32_t step) {
  return step >= 64 ? step / 16 : 1;
}

std::vector<std::uint32_t> each_of(std::size_t count, std::uint32_t step) {
  std::vector<std::uint32_t> result(chunk_count(count, step));
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = static_cast<std::uint32_t>(i * step);
  return result;
}

/// Of each step-th point.
template <class Filter>
std::vector<std::uint32_t> left_by(const Filter& filter, std::span<const Point3> points, std::uint32_t step,
                                   const Context& context) {
  const std::size_t count = chunk_count(points.size(), step);
  std::vector<std::vector<std::uint32_t>> lists(chunk_count(count, grain));
  for_each_chunk(context, count, grain, [&](const Chunk& chunk) {
    filter.append_others(points, chunk.begin, chunk.end, step, lists[chunk.index]);
  });
  std::size_t total = 0;
  for (const auto& list : lists) total += list.size();
  std::vector<std::uint32_t> result;
  result.reserve(total);
  for (const auto& list : lists) result.insert(result.end(), list.begin(), list.end());
  return result;
}

/// Worth a pass over the points, and what they cost in memory.
bool drops_many(std::size_t left, std::size_t of) {
  return 8 * left < 7 * of;
}

/// By the planes of a hull of few points that reach far.
std::vector<std::uint32_t> left_by_planes(std::span<const Point3> points, std::uint32_t step, double largest,
                                          const Simplex& simplex, const Context& context) {
  const HullOfSome small(points, extremes(points, context), simplex, context);
  const HullFilter planes(small.builder, largest);
  const std::uint32_t tried = std::max(step, static_cast<std::uint32_t>(points.size() / few_points));
  const std::size_t count = chunk_count(points.size(), tried);
  if (!drops_many(left_by(planes, points, tried, context).size(), count)) return each_of(points.size(), step);
  return left_by(planes, points, step, context);
}

}  // namespace

std::vector<std::uint32_t> hull_candidates(std::span<const Point3> points, double largest, const Simplex& simplex,
                                           const Context& context) {
  if (points.size() < many_points) return each_of(points.size(), 1);
  if (points.size() < very_many_points) return left_by_planes(points, 1, largest, simplex, context);
  auto step = static_cast<std::uint32_t>(points.size() / few_points);
  std::vector<std::uint32_t> some = each_of(points.size(), step);
  std::optional<HullReach> reach;
  while (step > 1) {
    // The hull of so many would tell little more than it costs.
    if (some.size() > most_points) return left_by(*reach, points, 1, context);
    const HullOfSome hull(points, some, simplex, context);
    step = finer(step);
    reach.emplace(hull.builder, largest, context);
    some = left_by(*reach, points, step, context);
    if (2 * some.size() < chunk_count(points.size(), step)) continue;
    // Of a thin hull that lies askew the table holds little.
    std::vector<std::uint32_t> by_planes = left_by_planes(points, step, largest, simplex, context);
    if (by_planes.size() > some.size()) continue;
    return step == 1 ? by_planes : left_by_planes(points, 1, largest, simplex, context);
  }
  return some;
}

}  // namespace quoin
