// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/square_grades.h"

#include <algorithm>
#include <cmath>
#include <numeric>
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
  const std::uint32_t count = list_.count;
  std::vector<Interval> squares;
  squares.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i % 4096 == 0) context.poll();
    squares.push_back(list_.bounds(i));
  }
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return squares[a].lower() < squares[b].lower() || (squares[a].lower() == squares[b].lower() && a < b);
  });
  context.poll();
  grade_.resize(count);
  for (std::size_t begin = 0; begin < count;) {
    double high = squares[order[begin]].upper();
    std::size_t end = begin + 1;
    for (; end < count && squares[order[end]].lower() <= high; ++end)
      high = std::max(high, squares[order[end]].upper());
    add_group(std::span(order).subspan(begin, end - begin), squares, context);
    begin = end;
  }
}

/// Of those whose bounds overlap, and with those of no others.
void SquareGrades::add_group(std::span<const std::uint32_t> group, std::span<const Interval> squares,
                             const Context& context) {
  const bool is_one = group.size() == 1 || std::ranges::all_of(group, [&](std::uint32_t i) {
                        return squares[i].is_point() && squares[i] == squares[group[0]];
                      });
  if (is_one) {
    add_grade(middle(squares[group[0]]), group[0]);
    for (const std::uint32_t i : group) add(i);
    return;
  }
  std::vector<std::pair<Rational, std::uint32_t>> sorted;
  for (const std::uint32_t i : group) {
    if (sorted.size() % 256 == 0) context.poll();
    sorted.emplace_back(list_.exact(i), i);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    if (k == 0 || sorted[k].first != sorted[k - 1].first) add_grade(sorted[k].first.to_double(), sorted[k].second);
    add(sorted[k].second);
  }
}

void SquareGrades::add_grade(double square, std::uint32_t example) {
  squares_.push_back(std::max(square, squares_.back()));
  example_.push_back(example);
}

void SquareGrades::add(std::uint32_t i) {
  grade_[i] = count() - 1;
  order_.push_back(i);
}

std::uint32_t SquareGrades::up_to(const Rational& square) const {
  if (square.sign() == Sign::negative) return 0;
  const Interval around = Interval::around(square);
  const auto above = std::partition_point(example_.begin(), example_.end(), [&](std::uint32_t i) {
    return is_at_most(
        list_.bounds(i), [&] { return list_.exact(i); }, square, around);
  });
  return 1 + static_cast<std::uint32_t>(above - example_.begin());
}

}  // namespace quoin::cli
