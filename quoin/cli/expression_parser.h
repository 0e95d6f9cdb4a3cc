// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "quoin/solid/expression.h"

namespace quoin::cli {

/// Parses a Boolean expression over names: `|` or `+` union, `-` difference, `^` symmetric difference, `&` or `*`
/// intersection, `!` or `~` complement, parentheses. Complement binds strongest, then intersection; the others bind
/// alike, from left to right. Leaf i of the result is names[i]. @throws InputError with the place in the text
Expression parse_expression(std::string_view text, const std::vector<std::string>& names);

}  // namespace quoin::cli
