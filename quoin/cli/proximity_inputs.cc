// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/proximity_inputs.h"

#include <cmath>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/polytope_inputs.h"
#include "quoin/cli/reporting.h"
#include "quoin/polytope/convex_boundary.h"
#include "quoin/polytope/convex_pieces.h"
#include "quoin/polytope/hull.h"

namespace quoin::cli {

ProximityOperand read_proximity_operand(const std::string& name, const Options& options,
                                        std::vector<std::string>& warnings, const Context& context) {
  ProximityOperand result{name, std::nullopt, nullptr, std::nullopt};
  const Input input = read_input(name, options, warnings, context);
  const Mesh* mesh = std::get_if<Mesh>(&input);
  if (mesh != nullptr && mesh->face_count() == 0) {
    result.pieces.emplace().push_back(polytope_of(mesh->vertices, name, context));
    const ConvexHull hull = convex_hull(mesh->vertices, context);
    if (hull.dimension == 3) {
      result.boundary = std::make_shared<const Brep>(convex_boundary(hull, mesh->vertices, title_of(name)));
    }
    return result;
  }
  const Solid solid = solid_of_input(input, name, warnings, context);
  if (solid.is_empty()) throw InputError(shown(name) + ": an empty solid has no distance from another");
  result.solid = solid;
  result.boundary = solid.shared_boundary();
  result.pieces = convex_pieces(*result.boundary, context);
  return result;
}

Solid solid_of(const ProximityOperand& operand, const Context& context) {
  if (operand.solid) return *operand.solid;
  if (!operand.boundary) {
    throw InputError(shown(operand.name) + ": the points are in a plane, and bound no solid: their distance is only " +
                     "known from convex ones, and how deep they lie in them along a direction from convex solids");
  }
  return Solid::from_leaf(quoin::make_leaf(*operand.boundary, title_of(operand.name), {}, context).leaf, context);
}

std::optional<Vector3> as_doubles(const RationalPoint3& v) {
  const Vector3 rounded{v.x.to_double(), v.y.to_double(), v.z.to_double()};
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(rounded[axis]) || Rational(rounded[axis]) != v[axis]) return std::nullopt;
  }
  return rounded;
}

}  // namespace quoin::cli
