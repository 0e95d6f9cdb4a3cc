// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

/// A number that tells lists of intervals apart, whatever their order: programs that print the same have found the same
/// intervals, but for chances of one in 2^64.
class IntervalSum {
 public:
  /// Without end, `death` is infinite.
  void add(int degree, double birth, double death) {
    sum_ += mixed(mixed(mixed(static_cast<std::uint64_t>(degree)) ^ std::bit_cast<std::uint64_t>(birth)) ^
                  std::bit_cast<std::uint64_t>(death));
  }
  std::uint64_t value() const { return sum_; }

 private:
  /// The finalizer of SplitMix64 (Steele, Lea and Flood 2014).
  static std::uint64_t mixed(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EB;
    return x ^ (x >> 31);
  }

  std::uint64_t sum_ = 0;
};
