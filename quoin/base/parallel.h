// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

#include "quoin/base/context.h"

namespace quoin {

/// Half-open range of element indices that one task handles.
struct Chunk {
  std::size_t index;  ///< number of the chunk, 0, 1, 2, ... in element order
  std::size_t begin;
  std::size_t end;
};

/// How many chunks `for_each_chunk` makes of `count` elements; depends on nothing but its arguments.
constexpr std::size_t chunk_count(std::size_t count, std::size_t grain) {
  return (count + grain - 1) / grain;
}

/// Calls `body` once per chunk of `grain` elements of [0, count), on at most context.threads() threads, and polls the
/// context before each chunk. The chunks do not depend on the number of threads: results written per chunk and
/// concatenated in chunk order are the same bytes on any machine. The first exception thrown is rethrown here; without
/// one, all chunks were done.
/// @throws std::system_error  resource_unavailable_try_again: a thread cannot be started
void for_each_chunk(const Context& context, std::size_t count, std::size_t grain,
                    const std::function<void(const Chunk&)>& body);

/// Runs both on at most context.threads() threads. The first exception thrown is rethrown here.
/// @throws std::system_error  as above
void run_both(const Context& context, const std::function<void()>& first, const std::function<void()>& second);

}  // namespace quoin
