// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/forced_end.h"

#include <linux/close_range.h>
#include <poll.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <ctime>
#include <utility>

// Much of this runs in a signal handler, on whatever thread: it may call what POSIX calls async-signal-safe, and what
// the kernel does by itself.

namespace quoin::cli {

namespace {

ForcedEndOptions prepared;
timer_t timer{};
std::atomic<bool> is_prepared{false};
std::atomic<bool> is_interrupted{false};
std::atomic<bool> is_ending{false};
std::atomic_flag is_held;
const char* file_to_remove = nullptr;  // while is_held

void sleep_for(long nanoseconds) {
  const timespec time{0, nanoseconds};
  nanosleep(&time, nullptr);
}

void hold() {
  while (is_held.test_and_set()) sleep_for(100'000);
}

sigset_t only_forced_end() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGALRM);
  return set;
}

/// Where it can be said at once: nobody may be reading.
void say(int descriptor, const std::string& words) {
  pollfd waiting{descriptor, POLLOUT, 0};
  if (words.empty() || ::poll(&waiting, 1, 0) != 1) return;
  [[maybe_unused]] const ssize_t said = write(descriptor, words.data(), words.size());
}

int wait_for_end_of(void* process) {
  const pid_t parent = *static_cast<pid_t*>(process);
  close_range(STDIN_FILENO, STDERR_FILENO, 0);  // others may wait for their end
  while (getppid() == parent) sleep_for(500'000);
  _exit(0);
}

/// Memory goes with the last process that has it, and whoever waits for this one would wait for gigabytes to go. So
/// that another has it too, for those moments. Where there cannot be one, this process takes longer.
void leave_memory_to_another() {
  alignas(16) static std::array<char, 16384> stack;
  static pid_t self = 0;
  self = getpid();
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  clone(&wait_for_end_of, stack.data() + stack.size(), CLONE_VM, &self);
}

void end_by_force(int /*signal*/) {
  if (is_ending.exchange(true)) return;
  hold();
  if (file_to_remove != nullptr) unlink(file_to_remove);
  const LastWords& words = is_interrupted ? prepared.interrupted : prepared.out_of_time;
  say(STDOUT_FILENO, words.output);
  say(STDERR_FILENO, words.error);
  leave_memory_to_another();
  _exit(prepared.exit_code);
}

void set_timer(double seconds) {
  itimerspec time{};
  constexpr double most = 1e9;
  seconds = std::min(seconds, most);
  const double whole = std::floor(seconds);
  time.it_value.tv_sec = static_cast<time_t>(whole);
  time.it_value.tv_nsec = static_cast<long>((seconds - whole) * 1e9);
  timer_settime(timer, 0, &time, nullptr);
}

}  // namespace

void prepare_forced_end(ForcedEndOptions options) {
  prepared = std::move(options);
  struct sigaction action {};
  action.sa_handler = &end_by_force;
  action.sa_flags = SA_RESTART;
  sigaction(SIGALRM, &action, nullptr);
  const sigset_t signal = only_forced_end();
  pthread_sigmask(SIG_UNBLOCK, &signal, nullptr);
  if (timer_create(CLOCK_MONOTONIC, nullptr, &timer) != 0) return;
  is_prepared = true;
  if (prepared.seconds) set_timer(*prepared.seconds);
}

void force_end() noexcept {
  constexpr double soon = 1e-9;  // by the timer's signal, which waits while it is blocked
  if (is_prepared && !is_interrupted.exchange(true)) set_timer(soon);
}

void end_in_order() noexcept {
  static bool is_in_order = false;
  if (is_in_order) return;
  while (is_ending.exchange(true)) pause();
  is_in_order = true;
}

WithoutForcedEnd::WithoutForcedEnd() noexcept {
  const sigset_t signal = only_forced_end();
  pthread_sigmask(SIG_BLOCK, &signal, &before_);
  hold();
}

WithoutForcedEnd::~WithoutForcedEnd() {
  is_held.clear();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void WithoutForcedEnd::remove_at_forced_end(const char* name) noexcept {
  file_to_remove = name;
}

}  // namespace quoin::cli
