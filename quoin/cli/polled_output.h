// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <ostream>
#include <streambuf>
#include <string_view>
#include <vector>

namespace quoin::cli {

/// Keeps what is written to it in blocks of a megabyte, and polls for each of them.
class BlockBuffer : public std::streambuf {
 public:
  std::size_t block_count() const { return blocks_.size(); }
  std::string_view block(std::size_t i) const;

 protected:
  int_type overflow(int_type c) override;

 private:
  static constexpr std::size_t block_size = std::size_t{1} << 20;
  std::vector<std::unique_ptr<char[]>> blocks_;
};

/// Hands on what is written to it, and polls for each 64 kilobytes.
class PolledBuffer : public std::streambuf {
 public:
  explicit PolledBuffer(std::ostream& out) : out_(out) {}

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;

 private:
  void count(std::streamsize size);

  std::ostream& out_;
  std::streamsize since_poll_ = 0;
};

}  // namespace quoin::cli
