// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "quoin/cli/options.h"

namespace quoin::cli {

/// Bytes that this process may still take: the least of what the machine has free and what limits of the process and
/// its group leave. Nothing where the system does not say.
std::optional<std::uint64_t> available_memory();

/// Bytes of swap space that are free. Nothing where the system does not say.
std::optional<std::uint64_t> swap_memory();

/// Bytes that this process holds in memory, but for pages of files. Nothing where the system does not say.
std::optional<std::uint64_t> own_memory();

inline constexpr double megabyte = 1e6;

/// Rounded up, with the unit.
std::string in_megabytes(std::uint64_t bytes);

/// Says on standard error what a run is about to take, if that is a gigabyte or more.
/// @throws InputError  it is more than options.memory, or else than what is available; with both numbers
void announce_memory(std::uint64_t bytes, std::size_t points, const Options& options);

}  // namespace quoin::cli
