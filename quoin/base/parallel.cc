// SPDX-License-Identifier: Apache-2.0
#include "quoin/base/parallel.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>

#include "quoin/base/fork_join.h"

namespace quoin {

namespace {

// Isolated: work nested in a task whose sibling throws would otherwise stop early and return as if it were done.
using Group = oneapi::tbb::task_group_context;

// Inside a task of the same arena nested calls share its threads.
bool inside_arena() {
  return oneapi::tbb::this_task_arena::current_thread_index() != oneapi::tbb::task_arena::not_initialized;
}

template <class Work>
void in_arena(const Context& context, const Work& work) {
  if (inside_arena() && static_cast<unsigned>(oneapi::tbb::this_task_arena::max_concurrency()) == context.threads()) {
    work();
    return;
  }
  oneapi::tbb::task_arena arena(static_cast<int>(context.threads()));
  arena.execute(work);
}

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
  ForkJoin fork_join;
  const auto task = [&](std::size_t index) {
    const ForkedTask forked(fork_join);
    run(index);
  };
  Group group(Group::isolated);
  in_arena(context, [&] { oneapi::tbb::parallel_for(std::size_t{0}, chunks, task, group); });
}

void run_both(const Context& context, const std::function<void()>& first, const std::function<void()>& second) {
  if (context.threads() <= 1) {
    first();
    second();
    return;
  }
  ForkJoin fork_join;
  const auto task = [&](const std::function<void()>& work) {
    const ForkedTask forked(fork_join);
    work();
  };
  Group group(Group::isolated);
  in_arena(context, [&] { oneapi::tbb::parallel_invoke([&] { task(first); }, [&] { task(second); }, group); });
}

}  // namespace quoin
