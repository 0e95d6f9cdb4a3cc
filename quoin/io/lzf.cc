// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/lzf.h"

namespace quoin::io {

std::optional<std::string> unpack_lzf(std::string_view packed, std::size_t size, const Context& context) {
  constexpr std::size_t longest_copy = 264;  // from three bytes
  constexpr std::size_t poll_step = std::size_t{1} << 20;
  if (size / longest_copy > packed.size() / 2) return std::nullopt;
  std::string out;
  out.reserve(size);
  std::size_t next_poll = poll_step;
  std::size_t at = 0;
  while (at < packed.size()) {
    if (out.size() >= next_poll) {
      context.poll();
      next_poll = out.size() + poll_step;
    }
    const std::size_t control = static_cast<unsigned char>(packed[at++]);
    if (control < 32) {
      const std::size_t run = control + 1;
      if (run > packed.size() - at || run > size - out.size()) return std::nullopt;
      out.append(packed.substr(at, run));
      at += run;
      continue;
    }
    std::size_t length = control >> 5;
    if (length == 7) {
      if (at == packed.size()) return std::nullopt;
      length += static_cast<unsigned char>(packed[at++]);
    }
    length += 2;
    if (at == packed.size()) return std::nullopt;
    const std::size_t back = ((control & 31) << 8) + static_cast<unsigned char>(packed[at++]) + 1;
    if (back > out.size() || length > size - out.size()) return std::nullopt;
    for (std::size_t from = out.size() - back; length > 0; --length) out.push_back(out[from++]);  // may overlap
  }
  if (out.size() != size) return std::nullopt;
  return out;
}

}  // namespace quoin::io
