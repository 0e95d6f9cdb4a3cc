// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace quoin::detail {

/// Number of the calling thread, in order of first call.
inline std::atomic<unsigned> next_thread_number{0};
#if defined(__GNUC__)
__attribute__((tls_model("initial-exec")))
#endif
inline thread_local unsigned thread_number = ~0U;

/// Two counters that threads increment without disturbing each other; a lost increment is possible only with more
/// threads than cells.
class TierCounter {
 public:
  void count_filter() { increment(own_cell().filter); }
  void count_exact() { increment(own_cell().exact); }

  std::uint64_t filter() const {
    std::uint64_t sum = 0;
    for (const Cell& cell : cells_) sum += cell.filter.load(std::memory_order_relaxed);
    return sum;
  }
  std::uint64_t exact() const {
    std::uint64_t sum = 0;
    for (const Cell& cell : cells_) sum += cell.exact.load(std::memory_order_relaxed);
    return sum;
  }

 private:
  static constexpr unsigned cell_count = 16;
  struct alignas(64) Cell {
    std::atomic<std::uint64_t> filter{0};
    std::atomic<std::uint64_t> exact{0};
  };

  // Not an atomic addition: nobody else writes the cell, and the addition would cost more than the predicate.
  static void increment(std::atomic<std::uint64_t>& counter) {
    counter.store(counter.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }
  Cell& own_cell() {
    if (thread_number == ~0U) [[unlikely]]
      thread_number = next_thread_number.fetch_add(1, std::memory_order_relaxed);
    return cells_[thread_number % cell_count];
  }

  std::array<Cell, cell_count> cells_;
};

}  // namespace quoin::detail
