// SPDX-License-Identifier: Apache-2.0
#pragma once

#ifdef __has_feature
#if __has_feature(thread_sanitizer)
#define QUOIN_THREAD_SANITIZER
#endif
#endif
#ifdef __SANITIZE_THREAD__
#define QUOIN_THREAD_SANITIZER
#endif
#ifdef QUOIN_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace quoin {

/// Tells the thread sanitizer what TBB promises and it cannot see, since the library of TBB is not instrumented: what
/// came before the fork came before every task, and every task came before the end of the ForkJoin.
///
/// Says nothing between tasks, so that races between them are found. Does nothing in other builds.
class ForkJoin {
 public:
#ifdef QUOIN_THREAD_SANITIZER
  ForkJoin() {
    __tsan_release(&forked_);
  }
  ~ForkJoin() {
    __tsan_acquire(&joined_);
  }
  void enter() {
    __tsan_acquire(&forked_);
  }
  void leave() {
    __tsan_release(&joined_);
  }
#else
  ForkJoin() = default;
  void enter() {}
  void leave() {}
#endif
  ForkJoin(const ForkJoin&) = delete;
  ForkJoin& operator=(const ForkJoin&) = delete;

 private:
#ifdef QUOIN_THREAD_SANITIZER
  char forked_ = 0;
  char joined_ = 0;
#endif
};

/// One task between the fork and the join, left by an exception too.
class ForkedTask {
 public:
  explicit ForkedTask(ForkJoin& fork_join) : fork_join_(fork_join) { fork_join_.enter(); }
  ~ForkedTask() { fork_join_.leave(); }
  ForkedTask(const ForkedTask&) = delete;
  ForkedTask& operator=(const ForkedTask&) = delete;

 private:
  ForkJoin& fork_join_;
};

}  // namespace quoin
