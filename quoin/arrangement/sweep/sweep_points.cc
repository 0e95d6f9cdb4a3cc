// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sweep/sweep_points.h"

#include <bit>

namespace quoin {

PointIncidences::PointIncidences(std::size_t point_count, std::span<const Piece> pieces)
    : begin_(point_count + 1, 0), entries_(2 * pieces.size()) {
  for (const Piece& piece : pieces) {
    ++begin_[piece.left + 1];
    ++begin_[piece.right + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto piece = static_cast<std::uint32_t>(i);
    entries_[next[pieces[i].left]++] = 2 * piece;
    entries_[next[pieces[i].right]++] = 2 * piece + 1;
  }
}

namespace {

/// Orders like the double: sign, exponent and the leading bits of the fraction.
std::uint64_t ordered_bits(double key) {
  const auto bits = std::bit_cast<std::uint64_t>(key + 0.0);  // -0 becomes 0
  return (bits >> 63) != 0 ? ~bits : bits | (std::uint64_t{1} << 63);
}

}  // namespace

/// Three stable passes over the leading 33 bits; then neighbours that share these are few, or equal.
void sort_by_key(const Context& context, std::vector<KeyedPoint>& list) {
  if (std::is_sorted(list.begin(), list.end())) return;
  constexpr unsigned digit_bits = 11;
  constexpr std::size_t digits = std::size_t{1} << digit_bits;
  if (list.size() < digits / 2) {
    std::sort(list.begin(), list.end());
    return;
  }
  std::vector<KeyedPoint> other(list.size());
  for (unsigned pass = 0; pass < 3; ++pass) {
    context.poll();
    const unsigned shift = 64 - digit_bits * (3 - pass);
    const auto digit_of = [shift](const KeyedPoint& p) {
      return static_cast<std::size_t>(ordered_bits(p.key) >> shift) & (digits - 1);
    };
    std::vector<std::size_t> begin(digits + 1, 0);
    for (const KeyedPoint& p : list) ++begin[digit_of(p) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for (const KeyedPoint& p : list) other[begin[digit_of(p)]++] = p;
    list.swap(other);
  }
  const auto leading = [](const KeyedPoint& p) { return ordered_bits(p.key) >> (64 - 3 * digit_bits); };
  for (auto first = list.begin(); first != list.end();) {
    const auto last =
        std::find_if(first, list.end(), [&](const KeyedPoint& p) { return leading(p) != leading(*first); });
    if (!std::is_sorted(first, last)) std::sort(first, last);
    first = last;
  }
}

}  // namespace quoin
