// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/square_grades.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "quoin/flow/critical_values.h"

namespace quoin::cli {

namespace {

double middle(const Interval& interval) {
  if (!std::isfinite(interval.upper())) return interval.upper();
  return interval.lower() + (interval.upper() - interval.lower()) / 2;
}

}  // namespace

SquareGrades::SquareGrades(SquareList list, const Context& context) : list_(std::move(list)) {
  std::vector<Interval> squares;
  squares.reserve(list_.count);
  for (std::uint32_t i = 0; i < list_.count; ++i) {
    if (i % 4096 == 0) context.poll();
    squares.push_back(list_.bounds(i));
  }
  ranks_ = exact_ranks(squares, list_.numbers, context);
  order_ = ranks_.order();
  for (const std::uint32_t i : ranks_.first) {
    if (squares_.size() % 256 == 0) context.poll();
    const Interval square = squares[i].is_narrow() ? squares[i] : list_.numbers.closer(i);
    squares_.push_back(std::max(middle(square), squares_.back()));
  }
}

std::uint32_t SquareGrades::up_to(const Rational& square) const {
  if (square.sign() == Sign::negative) return 0;
  const Interval around = Interval::around(square);
  const auto above = std::partition_point(ranks_.first.begin(), ranks_.first.end(), [&](std::uint32_t i) {
    return is_at_most(
        list_.bounds(i), [&] { return list_.numbers.exact(i).rational(); }, square, around);
  });
  return 1 + static_cast<std::uint32_t>(above - ranks_.first.begin());
}

}  // namespace quoin::cli
