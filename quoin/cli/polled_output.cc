// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/polled_output.h"

#include "quoin/cli/interruption.h"

namespace quoin::cli {

std::string_view BlockBuffer::block(std::size_t i) const {
  const bool is_last = i + 1 == blocks_.size();
  return {blocks_[i].get(), is_last ? static_cast<std::size_t>(pptr() - pbase()) : block_size};
}

BlockBuffer::int_type BlockBuffer::overflow(int_type c) {
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  poll_running();
  blocks_.push_back(std::make_unique_for_overwrite<char[]>(block_size));
  setp(blocks_.back().get(), blocks_.back().get() + block_size);
  return sputc(traits_type::to_char_type(c));
}

PolledBuffer::int_type PolledBuffer::overflow(int_type c) {
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  count(1);
  out_.put(traits_type::to_char_type(c));
  return c;
}

std::streamsize PolledBuffer::xsputn(const char* text, std::streamsize size) {
  count(size);
  out_.write(text, size);
  return size;
}

void PolledBuffer::count(std::streamsize size) {
  constexpr std::streamsize step = 65536;
  since_poll_ += size;
  if (since_poll_ < step) return;
  since_poll_ = 0;
  poll_running();
}

}  // namespace quoin::cli
