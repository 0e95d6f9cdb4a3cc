// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/topology/coefficients.h"
#include "quoin/topology/pivot_bits.h"

namespace quoin {

/// Reduces the columns of one matrix of 1 and -1 from left to right: the owner of matrix reduction, over any ring of
/// `coefficients`.
///
/// To each column, multiples of earlier ones are added until its last row (its pivot) is that of no earlier column.
/// Over a field every column then is zero or has a pivot of its own. Over the integers only units are pivots: a column
/// whose last entry is none is put off, and `put_off_columns` gives what is left of these beside the pivots.
///
/// `Matrix` has rows(), columns() and for_each(column, f), which calls f(row, sign) in any order. A reduced column that
/// is as the matrix has it is not stored. O(n^3) at worst; close to linear where few columns are changed.
/// Source: Edelsbrunner, Letscher, Zomorodian (2002); Zomorodian, Carlsson (2005).
template <class Ring, class Matrix>
class ColumnReduction {
 public:
  static constexpr std::uint32_t none = PivotBits::none;
  using Value = typename Ring::Value;
  struct Entry {
    std::uint32_t row;
    [[no_unique_address]] Value value;
  };

  ColumnReduction(const Ring& ring, const Matrix& matrix, const Context& context)
      : ring_(ring),
        matrix_(matrix),
        context_(context),
        work_(matrix.rows()),
        column_of_pivot_(matrix.rows(), none),
        stored_(matrix.columns(), none) {
    if constexpr (!is_two) values_.resize(matrix.rows(), Value(0));
  }

  /// Reduces the next column; the pivot it gets, or `none`. Columns may be left out.
  std::uint32_t reduce(std::uint32_t column) {
    if ((++steps_ & 1023U) == 0) context_.poll();
    const std::uint32_t last = last_row(column);
    if (last == none) return none;
    if (column_of_pivot_[last] == none) return column_of_pivot_[last] = column, last;
    load(column);
    bool is_changed = false;
    for (std::uint32_t pivot = work_.largest(); pivot != none; pivot = work_.largest()) {
      const std::uint32_t earlier = column_of_pivot_[pivot];
      if (earlier == none) {
        if (!is_unit_at(pivot)) return put_off(), none;
        if (is_changed) store(column);
        clear();
        return column_of_pivot_[pivot] = column, pivot;
      }
      eliminate(pivot, earlier);
      is_changed = true;
    }
    return none;
  }

  /// Columns that have no unit as pivot, reduced until they have no entry in the row of a pivot. Their span with the
  /// pivots has the elementary divisors of the matrix: one for each pivot and those of these columns.
  std::vector<std::vector<Entry>> put_off_columns() {
    std::vector<std::vector<Entry>> result;
    for (const std::vector<Entry>& column : put_off_) {
      for (const Entry& entry : column) add(entry.row, ring_.of_sign(1), entry.value);
      std::vector<Entry> rest;
      for (std::uint32_t row = work_.largest(); row != none; row = work_.largest()) {
        if (column_of_pivot_[row] != none) {
          eliminate(row, column_of_pivot_[row]);
        } else {
          rest.push_back(take(row));
        }
      }
      if (!rest.empty()) result.push_back(std::move(rest));
    }
    return result;
  }

 private:
  static constexpr bool is_two = std::is_same_v<Ring, coefficients::Two>;

  std::uint32_t last_row(std::uint32_t column) const {
    std::uint32_t last = none;
    matrix_.for_each(column, [&](std::uint32_t row, int) { last = last == none ? row : std::max(last, row); });
    return last;
  }

  void load(std::uint32_t column) {
    matrix_.for_each(column, [&](std::uint32_t row, [[maybe_unused]] int sign) {
      if constexpr (is_two) {
        work_.toggle(row);
      } else {
        add(row, ring_.of_sign(1), ring_.of_sign(sign));
      }
    });
  }

  void add(std::uint32_t row, [[maybe_unused]] const Value& factor, [[maybe_unused]] const Value& value) {
    if constexpr (is_two) {
      work_.toggle(row);
    } else {
      const bool was_zero = ring_.is_zero(values_[row]);
      ring_.add_multiple(values_[row], factor, value);
      if (was_zero != ring_.is_zero(values_[row])) work_.toggle(row);
    }
  }

  // Adds the multiple of an earlier column that makes its pivot zero.
  void eliminate(std::uint32_t pivot, std::uint32_t earlier) {
    if ((++additions_ & 255U) == 0) context_.poll();
    const bool is_stored = stored_[earlier] != none;
    if constexpr (is_two) {
      if (!is_stored) return load(earlier);
      for (const Entry& entry : stored_column(earlier)) work_.toggle(entry.row);
    } else {
      const Value factor = ring_.annihilator(values_[pivot], value_at(pivot, earlier));
      if (is_stored) {
        for (const Entry& entry : stored_column(earlier)) add(entry.row, factor, entry.value);
      } else {
        matrix_.for_each(earlier, [&](std::uint32_t row, int sign) { add(row, factor, ring_.of_sign(sign)); });
      }
    }
  }

  // The entry of an earlier column at its pivot.
  Value value_at(std::uint32_t pivot, std::uint32_t column) const {
    if (stored_[column] != none) return stored_column(column)[0].value;
    int at_pivot = 0;
    matrix_.for_each(column, [&](std::uint32_t row, int sign) { at_pivot = row == pivot ? sign : at_pivot; });
    return ring_.of_sign(at_pivot);
  }

  bool is_unit_at([[maybe_unused]] std::uint32_t row) const {
    if constexpr (is_two) {
      return true;
    } else {
      return ring_.is_unit(values_[row]);
    }
  }

  Entry take(std::uint32_t row) {
    work_.toggle(row);
    if constexpr (is_two) {
      return {row, {}};
    } else {
      Entry entry{row, std::move(values_[row])};
      values_[row] = Value(0);
      return entry;
    }
  }

  void store(std::uint32_t column) {
    stored_[column] = static_cast<std::uint32_t>(begin_.size());
    begin_.push_back(entries_.size());
    for (std::uint32_t row = work_.largest(); row != none; row = work_.largest()) entries_.push_back(take(row));
    end_.push_back(entries_.size());
  }

  std::span<const Entry> stored_column(std::uint32_t column) const {
    const std::uint32_t at = stored_[column];
    return {entries_.data() + begin_[at], entries_.data() + end_[at]};
  }

  void put_off() {
    put_off_.emplace_back();
    for (std::uint32_t row = work_.largest(); row != none; row = work_.largest()) put_off_.back().push_back(take(row));
  }

  void clear() {
    for (std::uint32_t row = work_.largest(); row != none; row = work_.largest()) take(row);
  }

  Ring ring_;
  const Matrix& matrix_;
  const Context& context_;
  PivotBits work_;
  std::vector<Value> values_;  // of the column at work, by rows; none modulo 2
  std::vector<std::uint32_t> column_of_pivot_;
  std::vector<std::uint32_t> stored_;  // by columns: the place in begin_ and end_, or `none`
  std::vector<std::size_t> begin_;
  std::vector<std::size_t> end_;
  std::vector<Entry> entries_;  // the first of each column is that of its pivot
  std::vector<std::vector<Entry>> put_off_;
  std::size_t steps_ = 0;
  std::size_t additions_ = 0;
};

}  // namespace quoin
