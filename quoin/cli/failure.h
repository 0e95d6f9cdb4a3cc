// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "quoin/base/error.h"
#include "quoin/cli/forced_end.h"
#include "quoin/cli/options.h"

namespace quoin::cli {

inline constexpr int exit_refused = 1;
inline constexpr int exit_usage = 2;
inline constexpr int exit_file = 3;
inline constexpr int exit_cancelled = 4;

/// The command line asks for what cannot be; found before anything is computed.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// Why a command, or its work on one file, came to nothing.
struct Failure {
  std::string message;
  int exit_code = exit_refused;
};

/// Of the exception that is being handled; after a signal that interrupts, or a lack of memory, that.
Failure current_failure();

/// `error` and `exit_code`.
nlohmann::ordered_json as_json(const Failure& failure);

/// On standard error and, where --json is given, as JSON where the report would go; once if that is the same place.
LastWords words_of(const Failure& failure, const Options& options);

/// Says these.
void print_failure(const Failure& failure, const Options& options);

}  // namespace quoin::cli
