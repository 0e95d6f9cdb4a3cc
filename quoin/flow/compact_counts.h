// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace quoin {

/// As many numbers of 32 bits as are asked for, zero at first. They take 2 bytes each, and 4 once one is larger than
/// that.
class CompactCounts {
 public:
  explicit CompactCounts(std::size_t size) : narrow_(size, 0) {}

  std::uint32_t operator[](std::size_t i) const { return wide_.empty() ? narrow_[i] : wide_[i]; }

  /// O(1); once O(n).
  void set(std::size_t i, std::uint32_t count) {
    if (wide_.empty() && count > std::numeric_limits<std::uint16_t>::max()) {
      wide_.assign(narrow_.begin(), narrow_.end());
      narrow_ = {};
    }
    if (wide_.empty()) {
      narrow_[i] = static_cast<std::uint16_t>(count);
    } else {
      wide_[i] = count;
    }
  }

 private:
  std::vector<std::uint16_t> narrow_;  ///< or
  std::vector<std::uint32_t> wide_;
};

}  // namespace quoin
