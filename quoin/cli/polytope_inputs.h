// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/kernel/point.h"
#include "quoin/polytope/polytope.h"

namespace quoin::cli {

/// The vertices of a file, whatever its faces are.
/// @throws InputError  of an unbounded solid, or where an exact vertex is no point of doubles
std::vector<Point3> read_vertices(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                                  const Context& context);

/// The vertices of a file that holds points without faces, which mean their hull, or a convex solid.
/// @throws InputError  also of a solid that is not convex, naming a reflex edge
std::vector<Point3> read_polytope(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                                  const Context& context);

/// The hull of points of that file. @throws InputError naming the file
Polytope polytope_of(const std::vector<Point3>& points, const std::string& name, const Context& context);

}  // namespace quoin::cli
