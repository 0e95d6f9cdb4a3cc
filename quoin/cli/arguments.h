// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "quoin/cli/options.h"

namespace quoin::cli {

/// Reads the command line into `options`. Returns the exit code where there is nothing to run: --help and --version, or
/// a command line that is not understood, which has been said by then.
std::optional<int> parse_arguments(int argc, char** argv, Options& options);

}  // namespace quoin::cli
