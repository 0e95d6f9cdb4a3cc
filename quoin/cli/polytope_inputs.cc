// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/polytope_inputs.h"

#include <iterator>
#include <type_traits>

#include "quoin/base/error.h"
#include "quoin/polytope/convex_pieces.h"
#include "quoin/polytope/notches.h"

namespace quoin::cli {

namespace {

/// Each vertex once, in the order of the corners.
InputPoints vertices_of(const Brep& boundary) {
  std::vector<bool> is_known(boundary.points.point_count());
  std::vector<PointId> ids;
  bool is_exact = true;
  for (const PointId corner : boundary.loop_vertices) {
    if (is_known[corner.index()]) continue;
    is_known[corner.index()] = true;
    ids.push_back(corner);
    is_exact = is_exact && boundary.points.is_exact(corner);
  }
  if (is_exact) {
    std::vector<Point3> points;
    for (const PointId id : ids) points.push_back(boundary.points.rounded(id));
    return points;
  }
  std::vector<RationalPoint3> points;
  for (const PointId id : ids) points.push_back(boundary.points.exact(id));
  return points;
}

InputPoints vertices_of(const Input& input, const std::string& name) {
  if (const Mesh* mesh = std::get_if<Mesh>(&input)) return mesh->vertices;
  const Brep& boundary = std::get<Brep>(input);
  if (boundary.is_unbounded) throw InputError(shown(name) + ": an unbounded solid has no convex hull but all of space");
  return vertices_of(boundary);
}

std::vector<RationalPoint3> as_rationals(const InputPoints& points) {
  if (const auto* rationals = std::get_if<std::vector<RationalPoint3>>(&points)) return *rationals;
  std::vector<RationalPoint3> result;
  for (const Point3& p : std::get<std::vector<Point3>>(points)) result.push_back(exact_point(p));
  return result;
}

void append(InputPoints& points, InputPoints more) {
  if (!std::holds_alternative<std::vector<Point3>>(points) || !std::holds_alternative<std::vector<Point3>>(more)) {
    points = as_rationals(points);
    more = as_rationals(more);
  }
  std::visit(
      [&](auto& all) {
        auto& others = std::get<std::remove_reference_t<decltype(all)>>(more);
        all.insert(all.end(), std::make_move_iterator(others.begin()), std::make_move_iterator(others.end()));
      },
      points);
}

std::string text_of(const RationalPoint3& p) {
  return "(" + p.x.to_string() + ", " + p.y.to_string() + ", " + p.z.to_string() + ")";
}

void require_convex(const Brep& boundary, const std::string& name, const Context& context) {
  if (boundary.is_unbounded) throw InputError(shown(name) + ": the solid is unbounded");
  if (boundary.shells.empty()) throw InputError(shown(name) + ": the solid is empty");
  if (boundary.shells.size() > 1) {
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

InputPoints read_vertices(std::span<const std::string> names, const Options& options,
                          std::vector<std::string>& warnings, const Context& context) {
  InputPoints points;
  for (const std::string& name : names) {
    append(points, vertices_of(read_input(name, options, warnings, context), name));
  }
  return points;
}

bool has_points_only(const Input& input) {
  const Mesh* mesh = std::get_if<Mesh>(&input);
  return mesh != nullptr && mesh->face_count() == 0 && !mesh->vertices.empty();
}

Polytope polytope_of(const InputPoints& points, const std::string& name, const Context& context) {
  try {
    return std::visit([&](const auto& all) { return Polytope::hull_of(all, context); }, points);
  } catch (const InputError& error) {
    throw InputError(shown(name) + ": " + error.what());
  }
}

Polytope read_polytope(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                       const Context& context) {
  const Input input = read_input(name, options, warnings, context);
  if (has_points_only(input)) return polytope_of(std::get<Mesh>(input).vertices, name, context);
  const Solid solid = solid_of_input(input, name, warnings, context);
  require_convex(solid.boundary(), name, context);
  return hull_of_boundary(solid.boundary(), context);
}

}  // namespace quoin::cli
