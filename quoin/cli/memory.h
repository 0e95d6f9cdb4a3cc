// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "quoin/cli/options.h"

namespace quoin::cli {

/// Bytes that this process may still take: the least of what the machine has free and what limits of the process and
/// its group leave. Nothing where the system does not say.
std::optional<std::uint64_t> available_memory();

/// Says on standard error what a run is about to take, if that is a gigabyte or more.
/// @throws InputError  it is more than options.memory, or else than what is available; with both numbers
void announce_memory(std::uint64_t bytes, std::size_t points, const Options& options);

}  // namespace quoin::cli
