// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/number/interval.h"
#include "quoin/number/rational.h"
#include "quoin/triangulation/exact_ranks.h"

namespace quoin::cli {

/// Squared distances of things by their numbers.
struct SquareList {
  std::uint32_t count = 0;
  std::function<Interval(std::uint32_t)> bounds;
  NumberSource numbers;
};

/// Squared distances, ascending, as grades: equal ones are one grade. Grade 0 is zero, before all of them. The order is
/// exact; doubles with bounds tell most of it.
class SquareGrades {
 public:
  /// What the list's functions need must outlive it. O(n log n) comparisons. @throws Cancelled
  SquareGrades(SquareList list, const Context& context);

  /// By ascending distance; ties by number.
  std::span<const std::uint32_t> order() const { return order_; }
  std::uint32_t count() const { return static_cast<std::uint32_t>(squares_.size()); }
  /// Within 2^-47 of itself; infinite beyond the largest double. Never descending.
  double square(std::uint32_t grade) const { return squares_[grade]; }
  std::uint32_t of(std::uint32_t i) const { return 1 + ranks_.rank[i]; }
  /// How many grades are at most this. Exact. O(log n)
  std::uint32_t up_to(const Rational& square) const;

 private:
  SquareList list_;
  std::vector<std::uint32_t> order_;
  ExactRanks ranks_;                // of grades but the first
  std::vector<double> squares_{0};  // by grade
};

}  // namespace quoin::cli
