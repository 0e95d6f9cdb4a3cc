// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <ostream>

namespace quoin {

/// Writes values to a stream as base64 of their little-endian bytes, through a buffer of fixed size.
class Base64Writer {
 public:
  explicit Base64Writer(std::ostream& out) : out_(out) {}
  Base64Writer(const Base64Writer&) = delete;
  Base64Writer& operator=(const Base64Writer&) = delete;

  void put(std::uint8_t byte) {
    bytes_[size_++] = byte;
    if (size_ == bytes_.size()) flush_whole_groups();
  }
  void put(std::uint16_t value) { put_bytes(value, 2); }
  void put(std::uint32_t value) { put_bytes(value, 4); }
  void put(float value) { put_bytes(std::bit_cast<std::uint32_t>(value), 4); }
  void put(double value) { put_bytes(std::bit_cast<std::uint64_t>(value), 8); }

  /// Writes what is left, padded; afterwards a new block may begin.
  void finish();

 private:
  void put_bytes(std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i) put(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  void flush_whole_groups();

  std::ostream& out_;
  std::array<std::uint8_t, 3072> bytes_;  // a multiple of 3
  std::size_t size_ = 0;
};

}  // namespace quoin
