// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/solid_sum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/polytope/convolution.h"
#include "quoin/polytope/solid_meeting.h"
#include "quoin/solid/overlay/overlay.h"
#include "quoin/solid/placement.h"
#include "quoin/solid/shapes.h"

namespace quoin {

namespace {

using SharedLeaf = std::shared_ptr<const Leaf>;

/// A box about the first surface and everything that the second reaches from it, with room to spare.
Mesh box_around(const Leaf& surface, const Leaf& tool) {
  const std::array<float, 6> outer = surface.tree.bounds();
  const std::array<float, 6> inner = tool.tree.bounds();
  Point3 low;
  Point3 high;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double reach = double{inner[axis + 3]} - double{inner[axis]};
    low[axis] = std::floor(double{outer[axis]} - 2 * reach) - 1;
    high[axis] = std::ceil(double{outer[axis + 3]} + 2 * reach) + 1;
  }
  return shapes::box(low, high);
}

RationalPoint3 vertex_of(const Leaf& leaf, std::uint32_t v) {
  return leaf.exact_vertices.empty() ? exact_point(leaf.vertices[v]) : leaf.exact_vertices[v];
}

/// A surface together with a box that it lies well inside of, turned inside out: what it leaves of the box. Whatever
/// `tool` reaches from the surface is inside the box too.
SharedLeaf complement_in_box(const Leaf& leaf, const Leaf& tool, const Context& context) {
  Mesh mesh = shapes::triangulated(box_around(leaf, tool));
  mesh.name = "the complement";
  std::vector<RationalPoint3> exact;
  for (const Point3& corner : mesh.vertices) exact.push_back(exact_point(corner));
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), leaf.vertices.begin(), leaf.vertices.end());
  for (const Tile& t : leaf.tiles) mesh.add_face(Tile{first + t[0], first + t[2], first + t[1]});
  if (leaf.exact_vertices.empty()) exact.clear();
  exact.insert(exact.end(), leaf.exact_vertices.begin(), leaf.exact_vertices.end());
  return plain_leaf(mesh, std::move(exact), context);
}

bool is_in_bounds(const RationalPoint3& p, const Leaf& leaf) {
  const std::array<float, 6> bounds = leaf.tree.bounds();
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (p[axis] < Rational(double{bounds[axis]}) || p[axis] > Rational(double{bounds[axis + 3]})) return false;
  }
  return true;
}

SharedLeaf convolve(const SharedLeaf& a, const SharedLeaf& b, const Context& context) {
  SharedLeaf surface = convolution(TiledSurface(*a), TiledSurface(*b), context);
  if (!surface) throw InternalError("a sum of solids has no boundary");
  return surface;
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
  if (a.is_empty()) return {};
  const SharedLeaf solid = leaf_of(a, "the first operand", context);
  const SharedLeaf tool = leaf_of(b, "the second operand", context);
  const SharedLeaf rest = complement_in_box(*solid, *tool, context);
  const Solid complement = Solid::from_leaf(rest, context);
  const Solid reflected_tool = reflected(b, {}, context);
  const SharedLeaf turned = leaf_of(reflected_tool, "the second operand", context);
  const SharedLeaf surface = convolve(rest, turned, context);
  SolidMeeting meeting(complement.boundary(), rest, reflected_tool.boundary(), turned, context);
  const auto kind_at = [&](const RationalPoint3& t) {
    if (!is_in_bounds(t + vertex_of(*tool, tool->tiles[0][0]), *solid)) return CellVerdict::outside;
    return meeting.with_reflection_at(t) ? CellVerdict::inside : CellVerdict::hole;
  };
  return Solid::from_boundary(winding_boundary(surface, CellVerdict::hole, kind_at, context), "erosion", context);
}

SumEstimate estimate_sum(const Solid& a, const Solid& b) {
  const auto edges = [](const Brep& boundary) { return boundary.loop_vertices.size() / 2; };
  SumEstimate result{edges(a.boundary()), edges(b.boundary()), 0};
  result.edge_pairs = static_cast<double>(result.edges_of_first) * static_cast<double>(result.edges_of_second);
  return result;
}

}  // namespace quoin
