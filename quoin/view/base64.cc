// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/base64.h"

namespace quoin {
namespace {

constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

void encode_group(const std::uint8_t* bytes, char* text) {
  const unsigned bits = unsigned{bytes[0]} << 16 | unsigned{bytes[1]} << 8 | bytes[2];
  for (unsigned i = 0; i < 4; ++i) text[i] = digits[bits >> (18 - 6 * i) & 63U];
}

}  // namespace

void Base64Writer::flush_whole_groups() {
  std::array<char, 4096> text;
  std::size_t written = 0;
  std::size_t read = 0;
  for (; read + 3 <= size_; read += 3, written += 4) encode_group(&bytes_[read], &text[written]);
  out_.write(text.data(), static_cast<std::streamsize>(written));
  for (std::size_t i = read; i < size_; ++i) bytes_[i - read] = bytes_[i];
  size_ -= read;
}

void Base64Writer::finish() {
  flush_whole_groups();
  if (size_ == 0) return;
  for (std::size_t i = size_; i < 3; ++i) bytes_[i] = 0;
  std::array<char, 4> text;
  encode_group(bytes_.data(), text.data());
  for (std::size_t i = size_ + 1; i < 4; ++i) text[i] = '=';
  out_.write(text.data(), 4);
  size_ = 0;
}

}  // namespace quoin
