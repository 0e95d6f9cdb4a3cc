// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/placement.h"

#include <cmath>
#include <string>
#include <utility>

#include "quoin/base/error.h"

namespace quoin {

namespace {

enum class Turn { none, over };

bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::shared_ptr<const Leaf> placed(const Leaf& leaf, const RationalPoint3& by, Turn turn, const Context& context) {
  Mesh mesh;
  mesh.name = leaf.name;
  std::vector<RationalPoint3> exact;
  bool are_doubles = true;
  for (std::uint32_t v = 0; v < leaf.vertices.size(); ++v) {
    const RationalPoint3 p = leaf.exact(v);
    exact.push_back(turn == Turn::over ? by - p : by + p);
    const RationalPoint3& q = exact.back();
    mesh.vertices.push_back({q.x.to_double(), q.y.to_double(), q.z.to_double()});
    are_doubles = are_doubles && is_finite(mesh.vertices.back()) && exact_point(mesh.vertices.back()) == q;
  }
  for (const Tile& tile : leaf.tiles) mesh.add_face(turn == Turn::over ? Tile{tile[0], tile[2], tile[1]} : tile);
  if (are_doubles) exact.clear();
  return plain_leaf(mesh, std::move(exact), context);
}

}  // namespace

std::shared_ptr<const Leaf> plain_leaf(const Mesh& mesh, std::vector<RationalPoint3> exact_vertices,
                                       const Context& context) {
  LeafOptions options;
  options.find_crossings = false;
  LeafResult result = make_leaf(mesh, std::move(exact_vertices), options, context);
  if (result.diagnosis.not_finite.count != 0) throw InputError(mesh.name + ": a point leaves the range of doubles");
  if (!result.leaf) throw InputError(mesh.name + ": the surface is not closed");
  return result.leaf;
}

std::shared_ptr<const Leaf> leaf_of(const Solid& solid, const std::string& name, const Context& context) {
  if (solid.boundary().is_unbounded) throw InputError(name + " is unbounded");
  LeafOptions options;
  options.find_crossings = false;
  LeafResult result = make_leaf(solid.boundary(), name, options, context);
  if (!result.leaf) throw InputError(name + " bounds no solid");
  return result.leaf;
}

std::shared_ptr<const Leaf> translated(const Leaf& leaf, const RationalPoint3& by, const Context& context) {
  return placed(leaf, by, Turn::none, context);
}

std::shared_ptr<const Leaf> reflected(const Leaf& leaf, const RationalPoint3& by, const Context& context) {
  return placed(leaf, by, Turn::over, context);
}

Solid translated(const Solid& solid, const RationalPoint3& by, const Context& context) {
  if (solid.is_empty()) return {};
  return Solid::from_leaf(translated(*leaf_of(solid, "the solid", context), by, context), context);
}

Solid reflected(const Solid& solid, const RationalPoint3& by, const Context& context) {
  if (solid.is_empty()) return {};
  return Solid::from_leaf(reflected(*leaf_of(solid, "the solid", context), by, context), context);
}

}  // namespace quoin
