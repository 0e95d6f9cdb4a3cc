// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/number/rational.h"

namespace quoin::cli {

/// Numbers separated by commas or blanks, as `parse_exact_number` reads them. @throws InputError that names `what` and
/// the text, when there are not `count` finite numbers
std::vector<Rational> parse_coordinates(std::string_view text, std::size_t count, const std::string& what);

/// The same of an argument on the command line. @throws UsageError  also where all of the numbers at `direction` and
/// the two behind it are zero
std::vector<Rational> parse_argument(std::string_view text, std::size_t count, const std::string& what,
                                     std::optional<std::size_t> direction = {});

}  // namespace quoin::cli
