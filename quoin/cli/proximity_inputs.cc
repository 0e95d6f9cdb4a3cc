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

namespace {

Solid solid_of(const Input& input, const std::string& name, std::vector<std::string>& warnings,
               const Context& context) {
  LeafResult leaf = make_leaf(input, name, context);
  const std::vector<std::string> findings = describe(input, leaf.diagnosis);
  if (!leaf.leaf) throw InputError(refusal(name, "does not bound a solid", findings));
  for (const std::string& line : findings) warnings.push_back(shown(name) + ": " + line);
  const Brep* exact = std::get_if<Brep>(&input);
  if (exact == nullptr || !exact->is_unbounded) return Solid::from_leaf(std::move(leaf.leaf), context);
  const Solid operand = Solid::of_complement(std::move(leaf.leaf));
  return Solid::evaluate(Expression::leaf(0), {&operand, 1}, context);
}

}  // namespace

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
  const Solid solid = solid_of(input, name, warnings, context);
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
