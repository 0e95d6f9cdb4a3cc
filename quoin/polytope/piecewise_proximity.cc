// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/piecewise_proximity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "quoin/base/error.h"

namespace quoin {

PiecewiseProximity::PiecewiseProximity(std::vector<Polytope> first, std::vector<Polytope> second)
    : first_(std::move(first)), second_(std::move(second)) {
  if (first_.empty() || second_.empty()) throw InputError("an empty set has no distance from another");
  const auto is_flat = [](const Polytope& p) { return p.dimension() < 3; };
  if (std::ranges::any_of(first_, is_flat) && std::ranges::any_of(second_, is_flat)) {
    throw InputError("both sets have flat pieces: the sum of two of them is no solid");
  }
  for (const Polytope& p : first_) first_boxes_.push_back(box_of(p));
  for (const Polytope& p : second_) second_boxes_.push_back(box_of(p));
  pairs_.resize(first_.size() * second_.size());
}

PiecewiseProximity::Box PiecewiseProximity::box_of(const Polytope& p) {
  Box box{p.vertex(0), p.vertex(0)};
  for (std::uint32_t v = 1; v < p.vertex_count(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], p.vertex(v)[axis]);
      box.high[axis] = std::max(box.high[axis], p.vertex(v)[axis]);
    }
  }
  return box;
}

/// At most the square of the distance of the boxes anywhere on the way: sums and differences are each off by 2^-53 of
/// themselves, products by that and 2^-1074.
double PiecewiseProximity::squared_gap(std::size_t pair, const Vector3& from, const Vector3& to) const {
  const Box& a = first_boxes_[pair / second_.size()];
  const Box& b = second_boxes_[pair % second_.size()];
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = a.low[axis] + std::min(from[axis], to[axis]);
    const double high = a.high[axis] + std::max(from[axis], to[axis]);
    const double error =
        0x1p-51 * (std::fabs(low) + std::fabs(high) + std::fabs(b.low[axis]) + std::fabs(b.high[axis]));
    const double gap = std::max(low - b.high[axis], b.low[axis] - high) - error;
    if (gap > 0) sum += gap * gap;  // not if it is not a number
  }
  return std::max(0.0, sum * (1 - 0x1p-50) - 0x1p-1070);
}

PiecewiseProximity::Pair& PiecewiseProximity::pair_of(std::size_t index, const Context& context) {
  Pair& pair = pairs_[index];
  if (!pair.queries) {
    pair.queries =
        std::make_unique<ProximityQueries>(first_[index / second_.size()], second_[index % second_.size()], context);
  }
  return pair;
}

PiecewiseDistance PiecewiseProximity::distance(const Vector3& translation, const Context& context) {
  std::vector<double> gaps;
  for (std::size_t i = 0; i < pairs_.size(); ++i) gaps.push_back(squared_gap(i, translation, translation));
  struct Found {
    std::size_t pair;
    TranslationNearest nearest;
  };
  std::vector<Found> found;
  double reach = std::numeric_limits<double>::infinity();
  const auto ask = [&](std::size_t i) {
    Pair& pair = pair_of(i, context);
    found.push_back({i, pair.queries->nearest(translation, pair.hint)});
    reach = std::min(reach, found.back().nearest.squared_distance.upper());
  };
  const auto nearest_box = static_cast<std::size_t>(std::ranges::min_element(gaps) - gaps.begin());
  ask(nearest_box);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (i % 256 == 0) context.poll();
    if (i != nearest_box && gaps[i] <= reach) ask(i);
  }
  std::ranges::sort(found, {}, &Found::pair);
  const auto result_of = [&](std::size_t i) {
    return PiecewiseDistance{pairs_[i].queries->distance(translation, pairs_[i].hint), i / second_.size(),
                             i % second_.size()};
  };
  std::optional<PiecewiseDistance> best;
  for (const Found& f : found) {
    if (f.nearest.relation == Proximity::overlapping) return result_of(f.pair);
  }
  for (const Found& f : found) {
    if (f.nearest.squared_distance.lower() > reach) continue;
    PiecewiseDistance other = result_of(f.pair);
    if (!best || other.distance.squared_distance < best->distance.squared_distance) best = std::move(other);
  }
  return *best;
}

std::vector<PiecewisePassage> PiecewiseProximity::passages(const Vector3& from, const Vector3& to,
                                                           const Context& context) {
  for (const Vector3& end : {from, to}) {
    if (!std::isfinite(end.x) || !std::isfinite(end.y) || !std::isfinite(end.z))
      throw InputError("an end of the way is not finite");
  }
  std::vector<PiecewisePassage> result;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (i % 256 == 0) context.poll();
    if (squared_gap(i, from, to) > 0) continue;
    Pair& pair = pair_of(i, context);
    TranslationPassage passage = pair.queries->passage(from, to, pair.hint, context);
    if (passage.relation == Proximity::apart) continue;
    result.push_back({std::move(passage), i / second_.size(), i % second_.size()});
  }
  std::ranges::stable_sort(
      result, [](const PiecewisePassage& a, const PiecewisePassage& b) { return a.passage.enter < b.passage.enter; });
  return result;
}

}  // namespace quoin
