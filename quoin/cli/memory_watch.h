// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "quoin/base/context.h"

namespace quoin::cli {

/// Cancels a run that takes more memory than it may: more than `megabytes` and an eighth, and 16 MB, since what is
/// asked for is an estimate; without them, than there was, swap space included. Looks a hundred times a second. Where
/// no thread can be started, nobody looks.
class MemoryWatch {
 public:
  /// The context must outlive the watch.
  /// @throws std::system_error  no thread can be started, and `megabytes` are asked for
  MemoryWatch(Context& context, std::optional<double> megabytes);
  ~MemoryWatch();
  MemoryWatch(const MemoryWatch&) = delete;
  MemoryWatch& operator=(const MemoryWatch&) = delete;

 private:
  void run(Context& context, std::uint64_t begun_with);

  std::uint64_t most_ = 0;
  bool is_asked_for_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool is_over_ = false;
  std::thread thread_;
};

/// What a watch that has cancelled a run has to say; nothing if none has.
std::optional<std::string> memory_refusal();

}  // namespace quoin::cli
