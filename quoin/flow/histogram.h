// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quoin {

/// How often each small number occurred.
class Histogram {
 public:
  void add(std::size_t value) {
    if (value >= counts_.size()) counts_.resize(value + 1, 0);
    ++counts_[value];
    ++count_;
  }

  std::size_t count() const { return count_; }
  std::size_t most() const { return counts_.empty() ? 0 : counts_.size() - 1; }
  /// 0 of nothing.
  double mean() const {
    double sum = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) sum += static_cast<double>(i) * static_cast<double>(counts_[i]);
    return count_ == 0 ? 0 : sum / static_cast<double>(count_);
  }
  /// Of the values as a whole population.
  double deviation() const {
    const double middle = mean();
    double sum = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      const double off = static_cast<double>(i) - middle;
      sum += off * off * static_cast<double>(counts_[i]);
    }
    return count_ == 0 ? 0 : std::sqrt(sum / static_cast<double>(count_));
  }
  /// The value that occurs most often, the least of several.
  std::size_t mode() const {
    std::size_t best = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      if (counts_[i] > counts_[best]) best = i;
    }
    return best;
  }
  /// The least value that at least half of all do not exceed.
  std::size_t median() const {
    std::size_t seen = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      seen += counts_[i];
      if (2 * seen >= count_) return i;
    }
    return 0;
  }
  const std::vector<std::size_t>& counts() const { return counts_; }

 private:
  std::vector<std::size_t> counts_;
  std::size_t count_ = 0;
};

}  // namespace quoin
