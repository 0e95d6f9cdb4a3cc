// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/summary.h"
#include "quoin/io/exact_text.h"
#include "quoin/polytope/hull.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

/// @throws InputError naming a coordinate that is no double
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

/// Vertices of all files. Those of exact text must be doubles.
std::vector<Point3> read_points(const Options& options, std::vector<std::string>& warnings, const Context& context) {
  std::vector<Point3> points;
  for (const std::string& name : options.inputs) {
    const Input input = read_input(name, options, warnings, context);
    if (const Mesh* mesh = std::get_if<Mesh>(&input)) {
      points.insert(points.end(), mesh->vertices.begin(), mesh->vertices.end());
      continue;
    }
    const Brep& boundary = std::get<Brep>(input);
    if (boundary.is_unbounded)
      throw InputError(shown(name) + ": an unbounded solid has no convex hull but all of space");
    for (const PointId corner : boundary.loop_vertices)
      points.push_back(doubles_of(boundary.points.exact(corner), name));
  }
  return points;
}

/// The facets over the vertices alone.
Mesh mesh_of(const ConvexHull& hull, std::span<const Point3> points) {
  Mesh mesh;
  mesh.name = "hull";
  std::vector<std::uint32_t> place(points.size(), 0);
  for (const std::uint32_t v : hull.vertices) {
    place[v] = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(points[v]);
  }
  std::vector<std::uint32_t> corners;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    corners.clear();
    for (const std::uint32_t v : hull.facet(f)) corners.push_back(place[v]);
    mesh.add_face(corners);
  }
  return mesh;
}

Json counts_of(const ConvexHull& hull, std::size_t points) {
  const std::size_t edges = hull.dimension == 3   ? hull.corners.size() / 2
                            : hull.dimension == 2 ? hull.corners.size()
                            : hull.dimension == 1 ? 1
                                                  : 0;
  return {{"points", points},
          {"dimension", hull.dimension},
          {"vertices", hull.vertices.size()},
          {"edges", edges},
          {"facets", hull.facet_count()}};
}

}  // namespace

int run_hull(const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  const std::vector<Point3> points = read_points(options, warnings, context);
  if (points.empty()) throw InputError("there are no points to take the hull of");
  const ConvexHull hull = convex_hull(points, context);
  Json details = counts_of(hull, points.size());
  if (hull.dimension == 3) {
    const LeafResult leaf = make_leaf(mesh_of(hull, points), "hull", context);
    if (!leaf.leaf) throw InternalError("hull: its facets bound no solid");
    const Solid solid = Solid::from_leaf(leaf.leaf, context);
    return finish({solid.boundary(), "hull", std::move(warnings), start, std::move(details)}, options, context);
  }
  const std::string flat = "all points are in one " + std::string(hull.dimension == 2   ? "plane"
                                                                  : hull.dimension == 1 ? "line"
                                                                                        : "place");
  if (!options.outputs.empty()) throw InputError(flat + ": their hull bounds no solid that a file could hold");
  warnings.push_back(flat);
  details["warnings"] = warnings;
  if (options.json) {
    print_json(details, options);
    return 0;
  }
  if (!options.quiet) report_stream(options) << as_text(details);
  print_warnings(warnings, options);
  return 0;
}

}  // namespace quoin::cli
