// SPDX-License-Identifier: Apache-2.0
#include "quoin/base/context.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "quoin/base/error.h"

namespace quoin {

Context::Context(ContextOptions options)
    : options_(std::move(options)),
      threads_(options_.threads != 0 ? options_.threads : std::max(1U, std::thread::hardware_concurrency())) {
  if (options_.timeout) deadline_ = std::chrono::steady_clock::now() + *options_.timeout;
}

bool Context::is_cancelled() const noexcept {
  if (cancelled_.load(std::memory_order_relaxed)) return true;
  if (options_.most_polls && polls() > *options_.most_polls) return true;
  return deadline_ && std::chrono::steady_clock::now() >= *deadline_;
}

void Context::poll() const {
  if (cancelled_.load(std::memory_order_relaxed)) throw Cancelled("cancelled");
  if (deadline_ && std::chrono::steady_clock::now() >= *deadline_) throw Cancelled("out of time");
  if (options_.most_polls && polls_.fetch_add(1, std::memory_order_relaxed) >= *options_.most_polls)
    throw Cancelled("cancelled");
}

void Context::progress(std::string_view stage, double done) const {
  poll();
  if (options_.progress) options_.progress(stage, done);
}

}  // namespace quoin
