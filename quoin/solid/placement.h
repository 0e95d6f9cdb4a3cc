// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/solid/leaf.h"
#include "quoin/solid/solid.h"

namespace quoin {

/// The surface with every point p moved to by + p, or to by - p and turned over. Exact, O(n log n).
/// @throws InputError where a point leaves the range of doubles
std::shared_ptr<const Leaf> translated(const Leaf& leaf, const RationalPoint3& by, const Context& context);
std::shared_ptr<const Leaf> reflected(const Leaf& leaf, const RationalPoint3& by, const Context& context);

/// The same of evaluated solids. @throws InputError also of an unbounded one
Solid translated(const Solid& solid, const RationalPoint3& by, const Context& context);
Solid reflected(const Solid& solid, const RationalPoint3& by, const Context& context);

/// A leaf over the mesh's vertices, or over exact points that these are the nearest doubles of. Crossings are not
/// looked for. @throws InputError  it is not closed, or a point is not finite
std::shared_ptr<const Leaf> plain_leaf(const Mesh& mesh, std::vector<RationalPoint3> exact_vertices,
                                       const Context& context);

/// The boundary of a bounded solid as one leaf. @throws InputError  the solid is unbounded
std::shared_ptr<const Leaf> leaf_of(const Solid& solid, const std::string& name, const Context& context);

}  // namespace quoin
