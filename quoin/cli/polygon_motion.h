// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/cli/options.h"

namespace quoin::cli {

/// `polygon minkowski` and `polygon offset`: prints the report and returns the exit code.
int run_minkowski(const Options& options, const Context& context);
int run_offset(const Options& options, const Context& context);

}  // namespace quoin::cli
