// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace quoin::io {

/// Columns side by side that belong together, behind the coordinates.
struct ColumnPart {
  enum class Kind { intensity, colors, normals, unknown };
  Kind kind;
  std::size_t first;  ///< column, from 0
  std::size_t size() const { return kind == Kind::intensity ? 1 : 3; }
};

/// What columns without names are.
struct UsualColumns {
  std::vector<ColumnPart> parts;    ///< in the order of columns, no kind twice but `unknown`
  std::vector<ColumnPart> instead;  ///< what they could be as well; empty where there is no doubt
};

/// Whether columns without names, so many of them behind the coordinates, are of one of the usual orders: an intensity;
/// a triple; both in either order; two triples; and these with an intensity before, between or behind them.
bool are_usual(std::size_t columns);

/// Tells by what they hold what columns without names are. A triple is colours if all its numbers are whole and at most
/// 255 and some are above 1, and else normals if all have the length 1 (to a hundredth) or 0; what is not finite says
/// nothing. Of the orders, one with the fewest triples of unknown kind is taken, and of these the one with the
/// intensity farthest to the front, as PTS has it. O(values).
/// @param values  rows of `columns` numbers, for which are_usual
UsualColumns usual_columns(std::span<const double> values, std::size_t columns);

/// For messages, where `before` columns precede: "colours (4 to 6), an intensity (7)".
std::string described(std::span<const ColumnPart> parts, std::size_t before);

}  // namespace quoin::io
