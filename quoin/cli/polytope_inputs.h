// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/options.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/polytope/polytope.h"

namespace quoin::cli {

/// Doubles, where all coordinates are some, else rationals.
using InputPoints = std::variant<std::vector<Point3>, std::vector<RationalPoint3>>;

/// The vertices of all files, whatever their faces are. @throws InputError  of an unbounded solid
InputPoints read_vertices(std::span<const std::string> names, const Options& options,
                          std::vector<std::string>& warnings, const Context& context);

/// Whether a file holds points without faces, which mean their hull.
bool has_points_only(const Input& input);

/// The hull of points of that file, of any dimension. @throws InputError naming the file
Polytope polytope_of(const InputPoints& points, const std::string& name, const Context& context);

/// The hull of points, or a convex solid. @throws InputError  also of a solid that is not convex, naming a reflex edge
Polytope read_polytope(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                       const Context& context);

}  // namespace quoin::cli
