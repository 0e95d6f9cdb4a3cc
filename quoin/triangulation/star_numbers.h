// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace quoin {

/// Numbers few vertices 0, 1, 2, ... in the order in which they are met.
class StarNumbers {
 public:
  static constexpr std::uint32_t most = 64;

  StarNumbers() { keys_.fill(nothing); }

  /// Of at most `most` vertices between two calls of `clear`.
  unsigned number(std::uint32_t v) {
    std::size_t at = place(v);
    while (keys_[at] != v) {
      if (keys_[at] == nothing) {
        keys_[at] = v;
        numbers_[at] = static_cast<std::uint8_t>(count_);
        used_[count_++] = static_cast<std::uint8_t>(at);
        break;
      }
      at = (at + 1) % size;
    }
    return numbers_[at];
  }

  /// Whether a vertex has a number.
  bool has(std::uint32_t v) const {
    std::size_t at = place(v);
    while (keys_[at] != v && keys_[at] != nothing) at = (at + 1) % size;
    return keys_[at] == v;
  }

  void clear() {
    for (std::size_t i = 0; i < count_; ++i) keys_[used_[i]] = nothing;
    count_ = 0;
  }

 private:
  static constexpr unsigned size_bits = 8;
  static constexpr std::size_t size = std::size_t{1} << size_bits;
  static constexpr std::uint32_t nothing = 0xFFFFFFFF;

  static std::size_t place(std::uint32_t v) { return (v * 0x9E3779B1U) >> (32 - size_bits); }

  std::array<std::uint32_t, size> keys_;
  std::array<std::uint8_t, size> numbers_{};
  std::array<std::uint8_t, most> used_{};
  std::size_t count_ = 0;
};

}  // namespace quoin
