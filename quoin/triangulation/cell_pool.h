// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quoin {

/// Places of a cell array that are of no use: single ones that were used, and runs that never were.
class CellPool {
 public:
  std::size_t size() const { return singles_.size() + fresh_; }

  /// Room for so many more single ones.
  void reserve(std::size_t count) {
    const std::size_t size = singles_.size() + count;
    if (size > singles_.capacity()) singles_.reserve(std::max(size, 2 * singles_.capacity()));
  }
  void add(std::uint32_t cell) { singles_.push_back(cell); }
  void add_run(std::uint32_t begin, std::uint32_t end) {
    if (begin == end) return;
    runs_.emplace_back(begin, end);
    fresh_ += end - begin;
  }

  /// Single ones are then taken from the end of the array first.
  void sort() { std::sort(singles_.begin(), singles_.end()); }
  /// Of a pool that is not empty.
  std::uint32_t take() {
    if (!singles_.empty()) {
      const std::uint32_t cell = singles_.back();
      singles_.pop_back();
      return cell;
    }
    auto& [begin, end] = runs_.back();
    const std::uint32_t cell = begin++;
    if (begin == end) runs_.pop_back();
    --fresh_;
    return cell;
  }

  void take_all_of(CellPool& other) {
    singles_.insert(singles_.end(), other.singles_.begin(), other.singles_.end());
    for (const auto& [begin, end] : other.runs_) add_run(begin, end);
    other = {};
  }

  /// Parts of it, of like size, which take places from the beginning of the array first.
  std::vector<CellPool> divided(std::size_t count) {
    std::vector<CellPool> parts(count);
    for (std::size_t i = 0; i < singles_.size(); ++i) parts[i % count].add(singles_[i]);
    std::sort(runs_.rbegin(), runs_.rend());
    for (std::size_t i = 0; i < runs_.size(); ++i) parts[i % count].add_run(runs_[i].first, runs_[i].second);
    *this = {};
    return parts;
  }

  /// Leaves out the runs at the end of an array of this size; gives the size without them.
  std::size_t without_end(std::size_t size) {
    std::sort(runs_.begin(), runs_.end());
    while (!runs_.empty() && runs_.back().second == size) {
      size = runs_.back().first;
      fresh_ -= runs_.back().second - runs_.back().first;
      runs_.pop_back();
    }
    return size;
  }

  std::vector<std::uint32_t> places() const {
    std::vector<std::uint32_t> all = singles_;
    all.reserve(size());
    for (const auto& [begin, end] : runs_) {
      for (std::uint32_t cell = begin; cell < end; ++cell) all.push_back(cell);
    }
    return all;
  }

 private:
  std::vector<std::uint32_t> singles_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> runs_;
  std::size_t fresh_ = 0;
};

}  // namespace quoin
