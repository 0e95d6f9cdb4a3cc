// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"

namespace quoin::cli {

/// Cancels `context`, which must outlive the guard, on SIGINT and SIGTERM. A read that waits is given up then.
class InterruptionGuard {
 public:
  explicit InterruptionGuard(Context& context);
  ~InterruptionGuard();
  InterruptionGuard(const InterruptionGuard&) = delete;
  InterruptionGuard& operator=(const InterruptionGuard&) = delete;
};

/// Polls the context of the guard that there is, if there is one: for what reads and writes, far from what computes.
/// @throws Cancelled
void poll_running();

/// Whether such a signal has come: whatever has failed since then may have failed for it.
bool was_interrupted();

}  // namespace quoin::cli
