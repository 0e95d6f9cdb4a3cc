// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/number/rational.h"
#include "quoin/topology/simplex_list.h"

namespace quoin {

/// Reads simplices: a line each, the numbers of its vertices (from 0 to 4294967294) in any order; '#' begins a comment.
/// @throws InputError naming file and line: another word, a vertex twice, more than 20 vertices; or no simplex at all
SimplexList read_simplices(std::string_view text, const std::string& name, const Context& context);

/// Simplices that enter one after another.
struct FiltrationText {
  SimplexList simplices;
  std::vector<std::uint32_t> grades;  ///< for each simplex the place of its value
  std::vector<Rational> values;       ///< distinct, in ascending order
};

/// The same with a value before the vertices of each simplex: a decimal, which stands for the nearest double, or an
/// integer or fraction p/q, exact.
FiltrationText read_filtration(std::string_view text, const std::string& name, const Context& context);

/// Whether a text begins, behind comments, like one of these: with a number.
bool begins_like_simplices(std::string_view text);

}  // namespace quoin
