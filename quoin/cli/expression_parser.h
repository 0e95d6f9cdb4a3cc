// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "quoin/base/context.h"
#include "quoin/solid/expression.h"

namespace quoin::cli {

/// Parses a Boolean expression over names: `|` or `+` union, `-` difference, `^` symmetric difference, `&` or `*`
/// intersection, `!` or `~` complement, parentheses. Complement binds strongest, then intersection; the others bind
/// alike, from left to right. Leaf i of the result is names[i].
///
/// Linear in the length of the text, at any depth: chains of one operator become one node, and nothing is recursive.
/// @throws UsageError  with the place in the text
/// @throws Cancelled
Expression parse_expression(std::string_view text, std::span<const std::string> names, const Context& context);

}  // namespace quoin::cli
