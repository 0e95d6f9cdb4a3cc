// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/polytope/polytope.h"

namespace quoin::cli {

/// Doubles, where all coordinates are some, else rationals.
using InputPoints = std::variant<std::vector<Point3>, std::vector<RationalPoint3>>;

std::vector<RationalPoint3> as_rationals(const InputPoints& points);

/// The vertices of all files, whatever their faces are. @throws InputError  of an unbounded solid
InputPoints read_vertices(std::span<const std::string> names, const Options& options,
                          std::vector<std::string>& warnings, const Context& context);

/// The vertices of a file that holds points without faces, which mean their hull, or a convex solid.
/// @throws InputError  also of a solid that is not convex, naming a reflex edge
InputPoints read_polytope(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                          const Context& context);

/// The hull of points of that file, of any dimension. @throws InputError naming the file
Polytope polytope_of(const InputPoints& points, const std::string& name, const Context& context);

}  // namespace quoin::cli
