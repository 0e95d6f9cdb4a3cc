// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/smith_form.h"

#include <algorithm>
#include <utility>

namespace quoin {

namespace {

bool is_zero(const Integer& a) {
  return a.sign() == Sign::zero;
}

// a / b, which leaves no rest.
Integer exact_quotient(const Integer& a, const Integer& b) {
  Integer result;
  mpz_divexact(result.raw(), a.raw(), b.raw());
  return result;
}

struct RankMinor {
  std::size_t rank = 0;
  Integer minor{1};  // the absolute value of one that is not zero, of order `rank`
};

// Each entry below and right of the pivots is a minor of the matrix, divided by none.
RankMinor rank_minor(IntegerMatrix a, const Context& context) {
  RankMinor result;
  const std::size_t columns = a.empty() ? 0 : a[0].size();
  for (std::size_t j = 0; j < columns && result.rank < a.size(); ++j) {
    context.poll();
    std::size_t row = result.rank;
    while (row < a.size() && is_zero(a[row][j])) ++row;
    if (row == a.size()) continue;
    std::swap(a[row], a[result.rank]);
    const std::vector<Integer>& top = a[result.rank];
    for (std::size_t i = result.rank + 1; i < a.size(); ++i) {
      context.poll();
      for (std::size_t l = j + 1; l < columns; ++l)
        a[i][l] = exact_quotient(top[j] * a[i][l] - a[i][j] * top[l], result.minor);
      a[i][j] = Integer(0);
    }
    result.minor = top[j];
    ++result.rank;
  }
  result.minor = abs(std::move(result.minor));
  return result;
}

// Elimination modulo a number, in rows and columns, with the least entry as pivot.
class ModularSmith {
 public:
  ModularSmith(IntegerMatrix matrix, const Integer& modulus, const Context& context)
      : a_(std::move(matrix)), modulus_(modulus), half_(modulus >> 1), context_(context) {
    for (std::vector<Integer>& row : a_)
      for (Integer& entry : row) shrink(entry);
  }

  // Diagonal entries that are not zero modulo the modulus, in no order of divisibility.
  std::vector<Integer> diagonal() {
    std::vector<Integer> result;
    while (move_least_to_corner()) {
      while (!clear_row_and_column()) move_least_of_cross_to_corner();
      result.push_back(greatest_common_divisor(a_[corner_][corner_], modulus_));
      ++corner_;
    }
    return result;
  }

 private:
  // To the residue of least absolute value.
  void shrink(Integer& value) const {
    value -= floor_quotient(value, modulus_) * modulus_;
    if (value > half_) value -= modulus_;
  }

  std::size_t columns() const { return a_.empty() ? 0 : a_[0].size(); }

  void swap_columns(std::size_t j, std::size_t l) {
    if (j == l) return;
    for (std::vector<Integer>& row : a_) std::swap(row[j], row[l]);
  }

  bool move_least_to_corner() {
    context_.poll();
    std::size_t row = a_.size();
    std::size_t column = 0;
    for (std::size_t i = corner_; i < a_.size(); ++i) {
      for (std::size_t j = corner_; j < columns(); ++j) {
        if (is_zero(a_[i][j])) continue;
        if (row == a_.size() || abs(a_[i][j]) < abs(a_[row][column])) row = i, column = j;
      }
    }
    if (row == a_.size()) return false;
    std::swap(a_[row], a_[corner_]);
    swap_columns(column, corner_);
    return true;
  }

  // What is left in the row and column of the corner is less than it.
  void move_least_of_cross_to_corner() {
    const auto is_less = [&](const Integer& a) {
      return !is_zero(a) && (is_zero(a_[corner_][corner_]) || abs(a) < abs(a_[corner_][corner_]));
    };
    for (std::size_t i = corner_ + 1; i < a_.size(); ++i)
      if (is_less(a_[i][corner_])) std::swap(a_[i], a_[corner_]);
    for (std::size_t j = corner_ + 1; j < columns(); ++j)
      if (is_less(a_[corner_][j])) swap_columns(j, corner_);
  }

  bool clear_row_and_column() {
    context_.poll();
    const Integer pivot = a_[corner_][corner_];
    bool is_clear = true;
    for (std::size_t i = corner_ + 1; i < a_.size(); ++i) {
      if (is_zero(a_[i][corner_])) continue;
      const Integer q = floor_quotient(a_[i][corner_], pivot);
      for (std::size_t j = corner_; j < columns(); ++j) {
        a_[i][j] -= q * a_[corner_][j];
        shrink(a_[i][j]);
      }
      is_clear = is_clear && is_zero(a_[i][corner_]);
    }
    if (!is_clear) return false;
    // Below the corner all is zero now, so that columns change in the first row alone.
    for (std::size_t j = corner_ + 1; j < columns(); ++j) {
      if (is_zero(a_[corner_][j])) continue;
      a_[corner_][j] -= floor_quotient(a_[corner_][j], pivot) * pivot;
      shrink(a_[corner_][j]);
      is_clear = is_clear && is_zero(a_[corner_][j]);
    }
    return is_clear;
  }

  IntegerMatrix a_;
  Integer modulus_;
  Integer half_;
  const Context& context_;
  std::size_t corner_ = 0;
};

// Makes each divide the next; the product of any two stays what it is.
void chain_divisors(std::vector<Integer>& d) {
  for (std::size_t i = 0; i < d.size(); ++i) {
    for (std::size_t j = i + 1; j < d.size(); ++j) {
      const Integer common = greatest_common_divisor(d[i], d[j]);
      d[j] = exact_quotient(d[i] * d[j], common);
      d[i] = common;
    }
  }
}

}  // namespace

Integer greatest_common_divisor(const Integer& a, const Integer& b) {
  Integer result;
  mpz_gcd(result.raw(), a.raw(), b.raw());
  return result;
}

std::vector<Integer> elementary_divisors(IntegerMatrix matrix, const Context& context) {
  const RankMinor found = rank_minor(matrix, context);
  if (found.rank == 0) return {};
  std::vector<Integer> divisors = ModularSmith(std::move(matrix), found.minor, context).diagonal();
  // Divisors that are the minor itself are zero modulo it.
  while (divisors.size() < found.rank) divisors.push_back(found.minor);
  chain_divisors(divisors);
  divisors.resize(found.rank);
  return divisors;
}

}  // namespace quoin
