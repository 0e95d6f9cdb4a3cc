// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/interruption.h"

#include <atomic>
#include <csignal>

#include "quoin/cli/forced_end.h"

namespace quoin::cli {

namespace {

std::atomic<Context*> running{nullptr};
std::atomic<bool> interrupted{false};

void cancel_running(int) {
  interrupted = true;
  if (Context* context = running.load()) context->cancel();
  force_end();
}

}  // namespace

InterruptionGuard::InterruptionGuard(Context& context) {
  running = &context;
  struct sigaction action {};
  action.sa_handler = &cancel_running;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

InterruptionGuard::~InterruptionGuard() {
  running = nullptr;
}

void poll_running() {
  if (const Context* context = running.load()) context->poll();
}

bool was_interrupted() {
  return interrupted;
}

}  // namespace quoin::cli
