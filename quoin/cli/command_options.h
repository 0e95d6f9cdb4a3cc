// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "quoin/cli/options.h"

namespace quoin::cli {

/// A command with the options that all have.
CLI::App* add_command(CLI::App& app, Options& options, const char* name, const char* text);

/// Every occurrence of such an option takes one value, so that operands may follow it.
CLI::Option* add_repeatable(CLI::App& command, const std::string& names, std::vector<std::string>& values,
                            const std::string& text);

}  // namespace quoin::cli
