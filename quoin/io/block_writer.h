// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"

namespace quoin::io {

/// Collects output in blocks of some size before it goes to the stream, the last of them with `finish`. Where that is
/// not reached, by an exception, the rest is lost: a stream may throw too, for the same reason.
class BlockWriter {
 public:
  BlockWriter(std::ostream& out, const Context& context) : out_(out), context_(context) {}
  BlockWriter(const BlockWriter&) = delete;
  BlockWriter& operator=(const BlockWriter&) = delete;

  BlockWriter& text(std::string_view s) {
    block_.append(s);
    if (block_.size() > 65536) {
      context_.poll();
      flush();
    }
    return *this;
  }

  /// Shortest decimals that read back to the same double.
  BlockWriter& number(double value) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return text({digits.data(), static_cast<std::size_t>(end - digits.data())});
  }

  BlockWriter& number(std::size_t value) {
    std::array<char, 24> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return text({digits.data(), static_cast<std::size_t>(end - digits.data())});
  }

  template <class T>
  BlockWriter& binary(T value, bool big_endian = false) {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (big_endian == (std::endian::native == std::endian::little)) {
      for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
    }
    return text({bytes.data(), bytes.size()});
  }

  void finish() { flush(); }

  BlockWriter& point(const Point3& p) { return number(p.x).text(" ").number(p.y).text(" ").number(p.z); }

 private:
  void flush() {
    out_.write(block_.data(), static_cast<std::streamsize>(block_.size()));
    block_.clear();
  }

  std::ostream& out_;
  const Context& context_;
  std::string block_;
};

}  // namespace quoin::io
