// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <ostream>

#include "quoin/cli/targets.h"

namespace quoin::cli {

/// Writes an output: first to memory, so that where `write` throws no file is touched and nothing is printed; then to a
/// file beside the one that is meant, which takes its place when it is whole. Polls all the while.
/// @throws FileError  it cannot be opened or written; Cancelled; whatever `write` throws
void write_target(const Target& target, const std::function<void(std::ostream&)>& write);

}  // namespace quoin::cli
