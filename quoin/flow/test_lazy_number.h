// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "quoin/number/interval.h"
#include "quoin/number/rational.h"

namespace quoin::testing {

/// A number that remembers how it was made: an interval at once, a rational when a sign needs it. For tests: evaluates
/// recursively, one allocation for each operation.
class LazyNumber {
 public:
  LazyNumber() : LazyNumber(Rational(0)) {}
  explicit LazyNumber(double value) : LazyNumber(Rational(value)) {}
  explicit LazyNumber(const Rational& value) : node_(std::make_shared<Node>()) {
    node_->interval = Interval::around(value);
    node_->exact = value;
  }

  Sign sign() const {
    const std::optional<Sign> known = node_->interval.sign();
    if (known) return *known;
    ++exact_signs;
    return exact().sign();
  }
  const Rational& exact() const { return node_->evaluate(); }

  friend LazyNumber operator+(const LazyNumber& a, const LazyNumber& b) {
    return {'+', a, b, a.node_->interval + b.node_->interval};
  }
  friend LazyNumber operator-(const LazyNumber& a, const LazyNumber& b) {
    return {'-', a, b, a.node_->interval - b.node_->interval};
  }
  friend LazyNumber operator*(const LazyNumber& a, const LazyNumber& b) {
    return {'*', a, b, a.node_->interval * b.node_->interval};
  }
  friend LazyNumber operator/(const LazyNumber& a, const LazyNumber& b) {
    return {'/', a, b, a.node_->interval / b.node_->interval};
  }

  static inline std::size_t exact_signs = 0;  ///< that intervals did not decide

 private:
  struct Node {
    Interval interval;
    std::optional<Rational> exact;
    char operation = 0;
    std::shared_ptr<Node> left{};
    std::shared_ptr<Node> right{};

    const Rational& evaluate() {
      if (exact) return *exact;
      const Rational& a = left->evaluate();
      const Rational& b = right->evaluate();
      exact = operation == '+' ? a + b : operation == '-' ? a - b : operation == '*' ? a * b : a / b;
      left.reset();
      right.reset();
      interval = Interval::around(*exact);
      return *exact;
    }
  };

  LazyNumber(char operation, const LazyNumber& a, const LazyNumber& b, const Interval& interval)
      : node_(std::make_shared<Node>(Node{interval, std::nullopt, operation, a.node_, b.node_})) {}

  std::shared_ptr<Node> node_;
};

}  // namespace quoin::testing
