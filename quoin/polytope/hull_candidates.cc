// SPDX-License-Identifier: Apache-2.0
//
// Few of the points, evenly chosen, have a hull, which tells which of 16 times as many may be corners; the hull of
// those tells of again 16 times as many, and in the end of all. Where points fill a body, what is left falls with the
// root of their number, so that all these hulls are small.
#include "quoin/polytope/hull_candidates.h"

#include "quoin/base/parallel.h"
#include "quoin/polytope/hull_filter.h"
#include "quoin/polytope/hull_of_some.h"
#include "quoin/polytope/hull_reach.h"

namespace quoin {

namespace {

constexpr std::size_t few_points = 1000;
constexpr std::uint32_t growth = 16;
constexpr std::size_t grain = 65536;

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
bool drops_half(std::size_t left, std::size_t of) {
  return 2 * left < of;
}

}  // namespace

std::vector<std::uint32_t> hull_candidates(std::span<const Point3> points, double largest, const Simplex& simplex,
                                           const Context& context) {
  std::uint32_t step = 1;
  while (points.size() / step > few_points) step *= growth;
  std::vector<std::uint32_t> some = each_of(points.size(), step);
  while (step > 1) {
    const HullOfSome hull(points, some, simplex, context);
    step /= growth;
    const std::size_t count = chunk_count(points.size(), step);
    some = left_by(HullReach(hull.builder, largest), points, step, context);
    if (drops_half(some.size(), count)) continue;
    const HullOfSome small(points, extremes(points, context), simplex, context);
    const HullFilter planes(small.builder, largest);
    const std::size_t left = left_by(planes, points, step, context).size();
    if (left < some.size() && drops_many(left, count)) return left_by(planes, points, 1, context);
    if (!drops_many(some.size(), count)) return each_of(points.size(), 1);
  }
  return some;
}

}  // namespace quoin
