// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull_of_some.h"

#include <algorithm>

#include "quoin/base/parallel.h"

namespace quoin {

namespace {

constexpr std::size_t grain = 16384;

std::vector<std::uint32_t> after_simplex(const Simplex& simplex, std::span<const std::uint32_t> others,
                                         const Context& context) {
  std::vector<std::uint32_t> order(simplex.points.begin(), simplex.points.end());
  order.reserve(others.size() + order.size());
  std::size_t polled = 0;
  for (const std::uint32_t i : others) {
    if (polled++ % grain == 0) context.poll();
    if (std::find(simplex.points.begin(), simplex.points.end(), i) == simplex.points.end()) order.push_back(i);
  }
  return order;
}

LargeVector<Point3> gather(std::span<const Point3> points, std::span<const std::uint32_t> order,
                           const Context& context) {
  LargeVector<Point3> result(order.size());
  for_each_chunk(context, order.size(), grain, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) result[i] = points[order[i]];
  });
  return result;
}

/// A few as they come.
RandomOrder rounds_of(std::span<const Point3> points, std::span<const std::uint32_t> chosen, const Context& context) {
  constexpr std::size_t few = 64;
  if (chosen.size() > few) return biased_random_order(points, chosen, context);
  RandomOrder order;
  order.points.assign(chosen.begin(), chosen.end());
  order.round_begin.back() = chosen.size();
  return order;
}

}  // namespace

HullOfSome::HullOfSome(std::span<const Point3> points, std::span<const std::uint32_t> chosen, const Simplex& simplex,
                       const Context& context)
    : HullOfSome(points, rounds_of(points, chosen, context), simplex, context) {}

HullOfSome::HullOfSome(std::span<const Point3> points, const RandomOrder& rounds, const Simplex& simplex,
                       const Context& context)
    : order(after_simplex(simplex, rounds.points, context)),
      ordered(gather(points, order, context)),
      builder(ordered, context) {
  builder.reserve(ordered.size());
  for (std::size_t round = 0; round < RandomOrder::rounds; ++round) {
    // Where rounds begin does not matter to a few points, of which four may have been in the simplex.
    const auto begin = std::max<std::size_t>(4, rounds.round_begin[round]);
    const auto end = round + 1 == RandomOrder::rounds ? ordered.size() : rounds.round_begin[round + 1];
    if (begin < end) builder.insert_many(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), context);
  }
}

}  // namespace quoin
