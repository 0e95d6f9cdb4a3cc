// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"

namespace quoin::cli {

/// Whether "-" is among the outputs.
bool data_goes_to_standard_output(const Options& options);

/// Where a result goes that is written to "-".
std::ostream& data_stream();

/// Where reports go: standard output, or standard error where a result goes to standard output.
std::ostream& report_stream(const Options& options);

/// Where warnings and errors go.
std::ostream& note_stream();

/// With '?' for what would steer a terminal; lines stay lines.
std::string printable(std::string text);

/// Reports; may be long, so it polls. @throws Cancelled
void print_json(const nlohmann::ordered_json& json, const Options& options);

/// @throws FileError  something written to standard output did not arrive
void flush_standard_output();

/// Says on standard error what runs: on a terminal one line that is rewritten, and erased by the functions above before
/// anything else is said; elsewhere, and only if `verbose`, one line as each stage begins. Empty when nothing is to be
/// said.
std::function<void(std::string_view stage, double done)> progress_printer(const Options& options);

/// Whether there is that one line.
bool progress_goes_to_terminal(const Options& options);

/// What erases it.
inline constexpr const char* erasing_line = "\r\x1b[K";

}  // namespace quoin::cli
