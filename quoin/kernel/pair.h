// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

/// Two doubles that one instruction computes with, as GCC and Clang offer them on every target; each lane rounds as a
/// double of its own.
namespace quoin::filter {

using Pair [[gnu::vector_size(16)]] = double;
using PairBits [[gnu::vector_size(16)]] = std::int64_t;

inline Pair swapped(Pair a) {
  return __builtin_shufflevector(a, a, 1, 0);
}

inline Pair magnitudes(Pair a) {
  return reinterpret_cast<Pair>(reinterpret_cast<PairBits>(a) & std::int64_t{0x7fffffffffffffff});
}

inline Pair larger(Pair a, Pair b) {
  return a > b ? a : b;
}

/// Of the four numbers.
inline double largest_magnitude(Pair a, Pair b) {
  const Pair both = larger(magnitudes(a), magnitudes(b));
  return std::max(both[0], both[1]);
}

}  // namespace quoin::filter
