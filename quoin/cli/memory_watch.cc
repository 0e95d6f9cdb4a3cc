// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/memory_watch.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <system_error>

#include "quoin/cli/memory.h"

namespace quoin::cli {

namespace {

enum class Refusal : std::uint8_t { none, asked_for, free };

std::atomic<Refusal> refusal{Refusal::none};
std::atomic<std::uint64_t> refused_at{0};

/// Signals go to other threads, whose reads they are to end.
class SignalsElsewhere {
 public:
  SignalsElsewhere() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsElsewhere() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsElsewhere(const SignalsElsewhere&) = delete;
  SignalsElsewhere& operator=(const SignalsElsewhere&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

MemoryWatch::MemoryWatch(Context& context, std::optional<double> megabytes) : is_asked_for_(megabytes.has_value()) {
  const auto begun_with = own_memory();
  if (!begun_with) return;
  if (megabytes) {
    constexpr double most = 1e18;
    most_ = static_cast<std::uint64_t>(std::min(most, *megabytes * megabyte * 9 / 8 + 16 * megabyte));
  } else {
    const auto free = available_memory();
    if (!free) return;
    // What is still there when a run is stopped lets others live, and this process end.
    most_ = *free + swap_memory().value_or(0);
    most_ -= most_ / 32;
  }
  const SignalsElsewhere elsewhere;
  try {
    thread_ = std::thread([this, &context, begun_with = *begun_with] { run(context, begun_with); });
  } catch (const std::system_error&) {
    if (is_asked_for_) throw;  // else an allocation fails where memory ends
  }
}

MemoryWatch::~MemoryWatch() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

void MemoryWatch::run(Context& context, std::uint64_t begun_with) {
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, std::chrono::milliseconds(10), [this] { return is_over_; })) {
    const auto now = own_memory();
    if (!now || *now < begun_with || *now - begun_with <= most_) continue;
    refused_at = *now - begun_with;
    refusal = is_asked_for_ ? Refusal::asked_for : Refusal::free;
    context.cancel();
    return;
  }
}

std::optional<std::string> memory_refusal() {
  const Refusal now = refusal;
  if (now == Refusal::none) return std::nullopt;
  return "stopped at " + in_megabytes(refused_at) + " of memory, more than " +
         (now == Refusal::asked_for ? "--memory allows" : "was free");
}

}  // namespace quoin::cli
