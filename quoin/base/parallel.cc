// SPDX-License-Identifier: Apache-2.0
#include "quoin/base/parallel.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

namespace quoin {

namespace {

#ifdef __SANITIZE_THREAD__

// The library of TBB is not instrumented, and its synchronisation is unknown to the thread sanitizer. That of plain
// threads is, so that races between tasks are found and nothing else is.
class PlainThreads {
 public:
  // Calls run(0) ... run(count - 1), each on the first thread that is free.
  template <class Run>
  static void for_each(unsigned threads, std::size_t count, const Run& run) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> has_failed{false};
    std::exception_ptr failure;
    std::mutex mutex;
    const auto work = [&] {
      for (std::size_t i = next++; i < count && !has_failed; i = next++) {
        try {
          run(i);
        } catch (...) {
          const std::scoped_lock lock(mutex);
          if (!failure) failure = std::current_exception();
          has_failed = true;
        }
      }
    };
    {
      std::vector<std::jthread> others;  // joined where one cannot be started
      for (std::size_t t = 1; t < std::min<std::size_t>(threads, count); ++t) others.emplace_back(work);
      work();
    }
    if (failure) std::rethrow_exception(failure);
  }
};

template <class Run>
void run_all(const Context& context, std::size_t count, const Run& run) {
  PlainThreads::for_each(context.threads(), count, run);
}

template <class First, class Second>
void run_two(const Context& context, const First& first, const Second& second) {
  PlainThreads::for_each(context.threads(), 2, [&](std::size_t i) { i == 0 ? first() : second(); });
}

#else

// Isolated: work nested in a task whose sibling throws would otherwise stop early and return as if it were done.
using Group = oneapi::tbb::task_group_context;

// Inside a task of the same arena nested calls share its threads.
bool inside_arena() {
  return oneapi::tbb::this_task_arena::current_thread_index() != oneapi::tbb::task_arena::not_initialized;
}

/// Says of TBB, which ends as a whole where it cannot start a thread, what a thread of the language says.
template <class Work>
void with_threads(const Work& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    if (!std::string_view(error.what()).starts_with("pthread_create")) throw;
    throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again), "cannot start a thread");
  }
}

template <class Work>
void in_arena(const Context& context, const Work& work) {
  if (inside_arena() && static_cast<unsigned>(oneapi::tbb::this_task_arena::max_concurrency()) == context.threads()) {
    work();
    return;
  }
  with_threads([&] {
    oneapi::tbb::task_arena arena(static_cast<int>(context.threads()));
    arena.execute(work);
  });
}

template <class Run>
void run_all(const Context& context, std::size_t count, const Run& run) {
  Group group(Group::isolated);
  in_arena(context, [&] { oneapi::tbb::parallel_for(std::size_t{0}, count, run, group); });
}

template <class First, class Second>
void run_two(const Context& context, const First& first, const Second& second) {
  Group group(Group::isolated);
  in_arena(context, [&] { oneapi::tbb::parallel_invoke(first, second, group); });
}

#endif

}  // namespace

void for_each_chunk(const Context& context, std::size_t count, std::size_t grain,
                    const std::function<void(const Chunk&)>& body) {
  const std::size_t chunks = chunk_count(count, grain);
  const auto run = [&](std::size_t index) {
    context.poll();
    body(Chunk{index, index * grain, std::min(count, (index + 1) * grain)});
  };
  if (context.threads() <= 1 || chunks <= 1) {
    for (std::size_t index = 0; index < chunks; ++index) run(index);
    return;
  }
  run_all(context, chunks, run);
}

void run_both(const Context& context, const std::function<void()>& first, const std::function<void()>& second) {
  if (context.threads() <= 1) {
    first();
    second();
    return;
  }
  run_two(context, first, second);
}

}  // namespace quoin
