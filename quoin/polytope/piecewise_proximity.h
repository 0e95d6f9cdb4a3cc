// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/polytope/proximity_queries.h"

namespace quoin {

/// How two sets of convex pieces lie to one another.
struct PiecewiseDistance {
  TranslationDistance distance{};  ///< of the nearest two, or of two that overlap if any do
  std::size_t first = 0;           ///< piece of the first set
  std::size_t second = 0;          ///< and of the second
};

/// A common part of a way with another piece.
struct PiecewisePassage {
  TranslationPassage passage{};  ///< touching or overlapping
  std::size_t first = 0;
  std::size_t second = 0;
};

/// Queries of a moving set of convex pieces, as a robot, and another set, as obstacles: those of all pairs, each with
/// its hint from the last query. Exact as these. Not safe to share between threads.
class PiecewiseProximity {
 public:
  /// Time and memory of all pairs' sums. @throws InputError if a set is empty or both pieces of a pair are flat,
  /// Cancelled
  PiecewiseProximity(std::span<const Polytope> first, std::span<const Polytope> second, const Context& context);

  /// The least distance of a pair, compared exactly where enclosures overlap; of equal ones the first.
  PiecewiseDistance distance(const Vector3& translation);

  /// All pairs that have common points on a straight way, by where these begin.
  std::vector<PiecewisePassage> passages(const Vector3& from, const Vector3& to, const Context& context);

  /// Of the pair.
  const ProximityQueries& queries(std::size_t first, std::size_t second) const {
    return pairs_[first * second_count_ + second].queries;
  }

 private:
  struct Pair {
    ProximityQueries queries;
    ProximityHint hint{};
  };
  std::size_t second_count_ = 0;
  std::vector<Pair> pairs_;
};

}  // namespace quoin
