// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/proximity_inputs.h"

namespace quoin::cli {

/// The places that a file of --path names, of the first solid from where it is, a line each. @throws InputError
std::vector<RationalPoint3> read_path(const Options& options);

/// Says what happens at each place of the path, and of convex pieces what happens between; draws the trail.
int run_path(const ProximityOperand& moving, const ProximityOperand& fixed, const std::vector<RationalPoint3>& path,
             const std::vector<std::string>& warnings, const Options& options, const Context& context);

}  // namespace quoin::cli
