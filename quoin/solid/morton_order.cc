// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/morton_order.h"

#include "quoin/base/parallel.h"

namespace quoin {

namespace {

std::uint32_t spread_bits(std::uint32_t x) {
  x = (x | (x << 16)) & 0x030000FFU;
  x = (x | (x << 8)) & 0x0300F00FU;
  x = (x | (x << 4)) & 0x030C30C3U;
  return (x | (x << 2)) & 0x09249249U;
}

std::vector<std::uint32_t> morton_keys(std::span<const FloatBox> boxes, const FloatBox& all, const Context& context) {
  std::array<float, 3> scale;
  for (std::size_t k = 0; k < 3; ++k) {
    const float extent = all.hi[k] / 2 - all.lo[k] / 2;
    scale[k] = extent > 0 ? 1023.0F / extent : 0.0F;
    if (!std::isfinite(extent) || !std::isfinite(scale[k])) scale[k] = 0;
  }
  std::vector<std::uint32_t> keys(boxes.size());
  for_each_chunk(context, boxes.size(), 16384, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      std::uint32_t key = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const float centre = (boxes[i].lo[k] / 2 - all.lo[k] / 2) / 2 + (boxes[i].hi[k] / 2 - all.lo[k] / 2) / 2;
        const float cell = std::min(std::max(0.0F, centre * scale[k]), 1023.0F);  // 0 where it is NaN
        key |= spread_bits(static_cast<std::uint32_t>(static_cast<std::int32_t>(cell))) << (2 - k);
      }
      keys[i] = key;
    }
  });
  return keys;
}

// Stable, in three passes of 10 bits.
void radix_sort(MortonOrder& result, const Context& context) {
  std::vector<std::uint32_t> other_keys(result.keys.size());
  std::vector<std::uint32_t> other_order(result.order.size());
  std::array<std::array<std::uint32_t, 1025>, 3> first{};
  for (const std::uint32_t key : result.keys) {
    for (unsigned pass = 0; pass < 3; ++pass) ++first[pass][((key >> (10 * pass)) & 1023U) + 1];
  }
  for (unsigned pass = 0; pass < 3; ++pass) {
    context.poll();
    for (std::size_t b = 0; b < 1024; ++b) first[pass][b + 1] += first[pass][b];
    for (std::size_t i = 0; i < result.keys.size(); ++i) {
      const std::uint32_t key = result.keys[i];
      const std::uint32_t at = first[pass][(key >> (10 * pass)) & 1023U]++;
      other_keys[at] = key;
      other_order[at] = result.order[i];
    }
    result.keys.swap(other_keys);
    result.order.swap(other_order);
  }
}

}  // namespace

MortonOrder morton_order(std::span<const FloatBox> boxes, const FloatBox& all, const Context& context) {
  MortonOrder result;
  result.keys = morton_keys(boxes, all, context);
  result.order.resize(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) result.order[i] = i;
  radix_sort(result, context);
  return result;
}

}  // namespace quoin
