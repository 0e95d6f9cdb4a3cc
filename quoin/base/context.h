// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace quoin {

/// How a long operation runs.
struct ContextOptions {
  unsigned threads = 0;    ///< 0: as many as the machine has
  std::uint64_t seed = 0;  ///< for algorithms that draw random numbers; the result never depends on threads
  std::optional<std::chrono::milliseconds> timeout{};  ///< from the construction of the Context
  /// Called now and then with a stage's name and the part of it that is done, in [0, 1]; from one thread at a time.
  std::function<void(std::string_view stage, double done)> progress{};
  /// As if `cancel` were called after so many polls, of all threads together: what a test can count on.
  std::optional<std::uint64_t> most_polls{};
};

/// Threads, progress, cancellation, time limit and seed of long operations.
///
/// `cancel` may be called from any thread or signal handler; the operation then throws Cancelled at its next poll,
/// which is never further than about 5 ms away, and leaves its inputs as they were.
class Context {
 public:
  explicit Context(ContextOptions options = {});
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  unsigned threads() const { return threads_; }
  std::uint64_t seed() const { return options_.seed; }

  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  bool is_cancelled() const noexcept;

  /// Throws Cancelled when `cancel` was called or the time is up. Cheap enough for every few hundred elements.
  void poll() const;

  /// How often it was polled; counted where `most_polls` is given.
  std::uint64_t polls() const noexcept { return polls_.load(std::memory_order_relaxed); }

  /// Reports progress and polls. Called by the thread that runs the operation, or by one at a time of those it runs on.
  void progress(std::string_view stage, double done) const;

 private:
  ContextOptions options_;
  unsigned threads_;
  std::atomic<bool> cancelled_{false};
  mutable std::atomic<std::uint64_t> polls_{0};
  std::optional<std::chrono::steady_clock::time_point> deadline_;
};

}  // namespace quoin
