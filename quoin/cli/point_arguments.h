// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "quoin/cli/options.h"

namespace quoin::cli {

/// `delaunay`, `voronoi`, `alpha` and `flow`.
void add_point_commands(CLI::App& app, Options& options);

}  // namespace quoin::cli
