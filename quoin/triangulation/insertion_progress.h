// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>

#include "quoin/base/context.h"

namespace quoin {

/// How many points several threads together have inserted, reported by one of them at a time.
class InsertionProgress {
 public:
  InsertionProgress(const Context& context, std::size_t all) : context_(context), all_(all) {}

  void add(std::size_t points) {
    done_.fetch_add(points, std::memory_order_relaxed);
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock.owns_lock()) return context_.poll();
    context_.progress("triangulate", static_cast<double>(done()) / static_cast<double>(all_));
  }
  std::size_t done() const { return done_.load(std::memory_order_relaxed); }

 private:
  const Context& context_;
  std::size_t all_;
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
};

}  // namespace quoin
