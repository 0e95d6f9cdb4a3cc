// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "quoin/number/rational.h"

namespace quoin::cli {

/// Which numbers an option takes.
struct NumberRange {
  bool (*holds)(const Rational&);
  const char* what;  ///< "below zero": why others are refused
};
extern const NumberRange any_number;
extern const NumberRange from_zero;
extern const NumberRange above_zero;
extern const NumberRange zero_to_one;

/// Options with one number each. Whatever is no such number, or is out of range, is a mistake of usage.

/// A decimal or p/q, as `parse_exact_number` reads it.
CLI::Option* add_exact_number(CLI::App& command, const std::string& names, std::optional<Rational>& value,
                              const NumberRange& range, const std::string& text);
/// A decimal whose nearest double counts.
CLI::Option* add_number(CLI::App& command, const std::string& names, std::optional<double>& value,
                        const NumberRange& range, const std::string& text);
/// Decimal digits alone; of fewer bits than 64, up to `most`.
CLI::Option* add_whole_number(CLI::App& command, const std::string& names,
                              const std::function<void(std::uint64_t)>& set, std::uint64_t least, std::uint64_t most,
                              const std::string& text);

}  // namespace quoin::cli
