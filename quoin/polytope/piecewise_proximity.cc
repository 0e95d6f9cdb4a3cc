// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/piecewise_proximity.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "quoin/base/error.h"

namespace quoin {

PiecewiseProximity::PiecewiseProximity(std::span<const Polytope> first, std::span<const Polytope> second,
                                       const Context& context)
    : second_count_(second.size()) {
  if (first.empty() || second.empty()) throw InputError("an empty set has no distance from another");
  for (const Polytope& p : first) {
    for (const Polytope& q : second) pairs_.push_back({ProximityQueries(p, q, context)});
  }
}

PiecewiseDistance PiecewiseProximity::distance(const Vector3& translation) {
  std::vector<TranslationNearest> nearest;
  double reach = std::numeric_limits<double>::infinity();
  for (Pair& pair : pairs_) {
    nearest.push_back(pair.queries.nearest(translation, pair.hint));
    reach = std::min(reach, nearest.back().squared_distance.upper());
  }
  const auto result_of = [&](std::size_t i) {
    return PiecewiseDistance{pairs_[i].queries.distance(translation, pairs_[i].hint), i / second_count_,
                             i % second_count_};
  };
  const auto overlapping = std::ranges::find(nearest, Proximity::overlapping, &TranslationNearest::relation);
  if (overlapping != nearest.end()) return result_of(static_cast<std::size_t>(overlapping - nearest.begin()));
  std::optional<PiecewiseDistance> best;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (nearest[i].squared_distance.lower() > reach) continue;
    PiecewiseDistance other = result_of(i);
    if (!best || other.distance.squared_distance < best->distance.squared_distance) best = std::move(other);
  }
  return *best;
}

std::vector<PiecewisePassage> PiecewiseProximity::passages(const Vector3& from, const Vector3& to,
                                                           const Context& context) {
  std::vector<PiecewisePassage> result;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    TranslationPassage passage = pairs_[i].queries.passage(from, to, pairs_[i].hint, context);
    if (passage.relation == Proximity::apart) continue;
    result.push_back({std::move(passage), i / second_count_, i % second_count_});
  }
  std::ranges::stable_sort(
      result, [](const PiecewisePassage& a, const PiecewisePassage& b) { return a.passage.enter < b.passage.enter; });
  return result;
}

}  // namespace quoin
