// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/polytope_inputs.h"

#include "quoin/base/error.h"
#include "quoin/cli/inputs.h"
#include "quoin/polytope/notches.h"

namespace quoin::cli {

namespace {

Point3 doubles_of(const RationalPoint3& exact, const std::string& name) {
  Point3 p;
  for (unsigned axis = 0; axis < 3; ++axis) {
    p[axis] = exact[axis].to_double();
    if (Rational(p[axis]) == exact[axis]) continue;
    throw InputError(shown(name) + ": a vertex has the coordinate " + exact[axis].to_string() +
                     ", which is no double: hulls of such points are not made yet");
  }
  return p;
}

std::vector<Point3> vertices_of(const Input& input, const std::string& name) {
  if (const Mesh* mesh = std::get_if<Mesh>(&input)) return mesh->vertices;
  const Brep& boundary = std::get<Brep>(input);
  if (boundary.is_unbounded) throw InputError(shown(name) + ": an unbounded solid has no convex hull but all of space");
  std::vector<Point3> points;
  points.reserve(boundary.loop_vertices.size());
  for (const PointId corner : boundary.loop_vertices) points.push_back(doubles_of(boundary.points.exact(corner), name));
  return points;
}

std::string text_of(const RationalPoint3& p) {
  return "(" + p.x.to_string() + ", " + p.y.to_string() + ", " + p.z.to_string() + ")";
}

void require_convex(const Brep& boundary, const std::string& name, const Context& context) {
  if (boundary.component_count > 1 || boundary.shells.size() > 1) {
    throw InputError(shown(name) + ": not convex: its boundary has " + std::to_string(boundary.shells.size()) +
                     " parts");
  }
  const std::vector<Notch> notches = find_notches(boundary, context);
  if (!notches.empty()) {
    throw InputError(shown(name) + ": not convex at the edge from " + text_of(boundary.points.exact(notches[0].a)) +
                     " to " + text_of(boundary.points.exact(notches[0].b)) +
                     "; only convex solids are taken here as yet");
  }
}

}  // namespace

std::vector<Point3> read_vertices(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                                  const Context& context) {
  return vertices_of(read_input(name, options, warnings, context), name);
}

std::vector<Point3> read_polytope(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                                  const Context& context) {
  const Input input = read_input(name, options, warnings, context);
  const Mesh* mesh = std::get_if<Mesh>(&input);
  if (mesh != nullptr && mesh->face_count() == 0) return mesh->vertices;
  const LeafResult leaf = make_leaf(input, name, context);
  if (!leaf.leaf) throw InputError(refusal(name, "does not bound a solid", describe(input, leaf.diagnosis)));
  if (mesh == nullptr) {
    require_convex(std::get<Brep>(input), name, context);
  } else {
    require_convex(Solid::from_leaf(leaf.leaf, context).boundary(), name, context);
  }
  return vertices_of(input, name);
}

Polytope polytope_of(const std::vector<Point3>& points, const std::string& name, const Context& context) {
  try {
    return Polytope::hull_of(points, context);
  } catch (const InputError& error) {
    throw InputError(shown(name) + ": " + error.what());
  }
}

}  // namespace quoin::cli
