// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
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

/// Queries of a moving set of convex pieces, as a robot, and another set, as obstacles: those of pairs, each with its
/// hint from the last query. Exact as these. A pair is made ready when it is asked for the first time; pairs whose
/// boxes are further apart than others are near are not asked. Not safe to share between threads.
class PiecewiseProximity {
 public:
  /// @throws InputError if a set is empty or has a flat piece while the other one has one too
  PiecewiseProximity(std::vector<Polytope> first, std::vector<Polytope> second);

  /// The least distance of a pair, compared exactly where enclosures overlap; of equal ones the first.
  /// @throws InputError if a number is not finite, Cancelled
  PiecewiseDistance distance(const Vector3& translation, const Context& context);

  /// All pairs that have common points on a straight way, by where these begin.
  /// @throws InputError if a number is not finite, Cancelled
  std::vector<PiecewisePassage> passages(const Vector3& from, const Vector3& to, const Context& context);

  /// Of a pair.
  const ProximityQueries& queries(std::size_t first, std::size_t second, const Context& context) {
    return *pair_of(first * second_.size() + second, context).queries;
  }

 private:
  struct Box {
    Point3 low;
    Point3 high;
  };
  struct Pair {
    std::unique_ptr<ProximityQueries> queries;
    ProximityHint hint{};
  };
  static Box box_of(const Polytope& p);
  double squared_gap(std::size_t pair, const Vector3& from, const Vector3& to) const;
  Pair& pair_of(std::size_t index, const Context& context);

  std::vector<Polytope> first_;
  std::vector<Polytope> second_;
  std::vector<Box> first_boxes_;
  std::vector<Box> second_boxes_;
  std::vector<Pair> pairs_;
};

}  // namespace quoin
