// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/solid/brep.h"

namespace quoin::cli {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start);

/// The stem of an input's name, as the title of what is made of it.
std::string title_of(const std::string& input);

/// A solid that a command has made.
struct Made {
  const Brep& boundary;
  std::string title;
  std::vector<std::string> warnings;
  Clock::time_point start;
  nlohmann::ordered_json details = nlohmann::ordered_json::object();  ///< further keys of the report
};

/// Writes the outputs and the report; the exit code: 1 where rounding failed and was not accepted.
int finish(Made made, const Options& options, const Context& context);

}  // namespace quoin::cli
