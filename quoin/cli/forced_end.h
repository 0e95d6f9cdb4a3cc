// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>
#include <optional>
#include <string>

namespace quoin::cli {

/// What a process says as it ends.
struct LastWords {
  std::string output;  ///< on standard output
  std::string error;   ///< on standard error
};

struct ForcedEndOptions {
  LastWords interrupted{};
  LastWords out_of_time{};
  std::optional<double> seconds{};  ///< the time that there is, from now on
  int exit_code = 0;
};

// What was cancelled ends by itself at its next poll, and what it holds is given back on the way. The poll may be far,
// though, where millions are sorted or a device is waited for, and gigabytes take a tenth of a second to be given back.
// A process ends by force instead, at an interruption or the time limit: with the words and the exit code that it would
// have had, and without files that are not whole. Its memory is given back behind its end, by a process that nobody
// waits for.

/// Sets the time limit. Once in a process; nothing below does anything before. Streams are not flushed at a forced end:
/// who reports before the end flushes.
void prepare_forced_end(ForcedEndOptions options);

/// The process ends, at once or behind the last guard. For signal handlers.
void force_end() noexcept;

/// No forced end comes from now on: the caller says the last words. Does not return where they were said.
void end_in_order() noexcept;

/// While there is one, a forced end waits: of what has to be done as a whole, and soon.
class WithoutForcedEnd {
 public:
  WithoutForcedEnd() noexcept;
  ~WithoutForcedEnd();
  WithoutForcedEnd(const WithoutForcedEnd&) = delete;
  WithoutForcedEnd& operator=(const WithoutForcedEnd&) = delete;

  /// A forced end removes this file, one at a time; null: none. Kept as a pointer. What was opened or removed or
  /// renamed under the same guard is never missed.
  void remove_at_forced_end(const char* name) noexcept;

 private:
  sigset_t before_{};
};

}  // namespace quoin::cli
