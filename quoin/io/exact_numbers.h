// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "quoin/io/exact_words.h"
#include "quoin/number/rational.h"
#include "quoin/topology/filtration.h"

namespace quoin {

/// A list of exact numbers most of which are doubles, 8 bytes for each; rationals that are none are kept beside them,
/// equal ones that follow each other once. A place may hold none.
class ExactNumbers {
 public:
  std::size_t size() const { return doubles_.size(); }
  /// The value must be finite; the negative zero is zero.
  void add(double value) { doubles_.push_back(value == 0 ? 0 : value); }
  void add(const Rational& value);
  void add(const io::ExactNumber& number);
  void add_none() { doubles_.push_back(none); }

  bool is_none(std::size_t i) const { return doubles_[i] == none; }
  bool is_double(std::size_t i) const { return std::isfinite(doubles_[i]); }
  /// Not of a place that holds none.
  Rational exact(std::size_t i) const { return is_double(i) ? Rational(doubles_[i]) : beside(i); }
  /// The nearest double, infinite beyond the largest.
  double rounded(std::size_t i) const { return is_double(i) ? doubles_[i] : beside(i).to_double(); }
  /// As exact text forms have it; "-" for none.
  std::string word(std::size_t i) const;

  /// Their places among the distinct ones in ascending order. Each must be there. O(n log n)
  Grades<Rational> grades() const;

  friend bool operator==(const ExactNumbers& a, const ExactNumbers& b);

 private:
  static constexpr double none = std::numeric_limits<double>::infinity();
  static constexpr double not_a_double = -none;
  const Rational& beside(std::size_t i) const;
  void add_beside(const Rational& value);

  std::vector<double> doubles_;
  std::vector<std::pair<std::size_t, Rational>> others_;  ///< with the first place of each
};

}  // namespace quoin
