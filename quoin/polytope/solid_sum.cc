// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/solid_sum.h"

#include <memory>

#include "quoin/base/error.h"
#include "quoin/polytope/complement_in_box.h"
#include "quoin/polytope/convolution.h"
#include "quoin/polytope/solid_meeting.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/overlay/overlay.h"
#include "quoin/solid/placement.h"

namespace quoin {

namespace {

using SharedLeaf = std::shared_ptr<const Leaf>;

SharedLeaf convolve(const SharedLeaf& a, const SharedLeaf& b, const Context& context) {
  return convolution(TiledSurface(*a), TiledSurface(*b), context);
}

}  // namespace

Solid minkowski_sum(const Solid& a, const Solid& b, const Context& context) {
  if (a.is_empty() || b.is_empty()) return {};
  const SharedLeaf first = leaf_of(a, "the first operand", context);
  const SharedLeaf second = leaf_of(b, "the second operand", context);
  SolidMeeting meeting(a.boundary(), first, b.boundary(), second, context);
  const auto kind_at = [&](const RationalPoint3& t) {
    return meeting.with_reflection_at(t) ? CellVerdict::inside : CellVerdict::hole;
  };
  return Solid::from_boundary(winding_boundary(convolve(first, second, context), CellVerdict::inside, kind_at, context),
                              "sum", context);
}

Solid erosion(const Solid& a, const Solid& b, const Context& context) {
  if (b.is_empty()) throw InputError("the second operand is empty: it fits everywhere");
  if (b.boundary().is_unbounded) throw InputError("the second operand is unbounded");
  if (a.is_empty()) return {};
  const ExactBox reach = exact_bounds(b.boundary());
  const Solid rest = complement_in_box(a, reach, context);
  const Solid tool = reflected(b, {}, context);
  const SharedLeaf rest_leaf = leaf_of(rest, "the complement", context);
  const SharedLeaf tool_leaf = leaf_of(tool, "the second operand", context);
  SolidMeeting meeting(rest.boundary(), rest_leaf, tool.boundary(), tool_leaf, context);
  const ExactBox bounds = exact_bounds(a.boundary());
  const auto kind_at = [&](const RationalPoint3& t) {
    if (!bounds.contains(t + reach.lo)) return CellVerdict::outside;
    return meeting.with_reflection_at(t) ? CellVerdict::inside : CellVerdict::hole;
  };
  return Solid::from_boundary(
      winding_boundary(convolve(rest_leaf, tool_leaf, context), CellVerdict::hole, kind_at, context), "erosion",
      context);
}

SumEstimate estimate_sum(const Solid& a, const Solid& b) {
  const auto edges = [](const Brep& boundary) { return boundary.loop_vertices.size() / 2; };
  SumEstimate result{edges(a.boundary()), edges(b.boundary()), 0};
  result.edge_pairs = static_cast<double>(result.edges_of_first) * static_cast<double>(result.edges_of_second);
  return result;
}

}  // namespace quoin
