// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/parallel.h"
#include "quoin/polytope/hull_candidates.h"
#include "quoin/polytope/hull_facets.h"
#include "quoin/polytope/hull_of_some.h"
#include "quoin/polytope/hull_simplex.h"
#include "quoin/polytope/planar_hull.h"

namespace quoin {

namespace {

constexpr std::size_t many_points = 1000;
constexpr std::size_t most_points = std::size_t{1} << 31;
constexpr std::size_t grain = 16384;
constexpr double half_range = std::numeric_limits<double>::max() / 2;

bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

[[noreturn]] void refuse(std::size_t i) {
  throw InputError("point " + std::to_string(i) + " has a coordinate that is not finite");
}

/// No sum of magnitudes of the coordinates of a point is larger, but for rounding. The first point that is not finite
/// is refused.
double largest_of_finite(std::span<const Point3> points, const Context& context) {
  struct Found {
    double largest = 0;
    std::size_t first_not_finite;
  };
  std::vector<Found> chunks(chunk_count(points.size(), grain));
  for_each_chunk(context, points.size(), grain, [&](const Chunk& chunk) {
    Found found{0, points.size()};
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Point3& p = points[i];
      const double size = std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z);
      if (!(size < half_range) && !is_finite(p)) found.first_not_finite = std::min(found.first_not_finite, i);
      found.largest = std::max(found.largest, size);
    }
    chunks[chunk.index] = found;
  });
  double largest = 0;
  for (const Found& found : chunks) {
    if (found.first_not_finite < points.size()) refuse(found.first_not_finite);
    largest = std::max(largest, found.largest);
  }
  return largest;
}

ConvexHull hull_of_flat(std::span<const Point3> points, const Simplex& simplex, const Context& context) {
  const unsigned axis = axis_to_drop(points[simplex.points[0]], points[simplex.points[1]], points[simplex.points[2]]);
  std::vector<Point2> flat;
  flat.reserve(points.size());
  for (const Point3& p : points) {
    if (flat.size() % 16384 == 0) context.poll();
    flat.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3]});
  }
  return hull_of_polygon(planar_hull(flat, context));
}

ConvexHull hull_of_solid(std::span<const Point3> points, double largest, const Simplex& simplex,
                         const Context& context) {
  HullOfSome hull(points, hull_candidates(points, largest, simplex, context), simplex, context);
  return join_facets(hull.builder, hull.order, points.size(), context);
}

}  // namespace

ConvexHull convex_hull(std::span<const Point3> points, const Context& context) {
  if (points.size() > most_points) throw InputError("there are more than 2^31 points");
  const double largest = largest_of_finite(points, context);
  // Mostly the first few tell; being first, they are the first of points that equal them.
  Simplex simplex = find_simplex(points.first(std::min(points.size(), many_points)), context);
  if (simplex.count < 4 && points.size() > many_points) simplex = find_simplex(points, context);
  if (simplex.count == 4) return hull_of_solid(points, largest, simplex, context);
  if (simplex.count == 3) return hull_of_flat(points, simplex, context);
  ConvexHull hull;
  hull.dimension = static_cast<int>(simplex.count) - 1;
  hull.vertices.assign(simplex.points.begin(), simplex.points.begin() + simplex.count);
  std::sort(hull.vertices.begin(), hull.vertices.end());
  return hull;
}

ConvexHull convex_hull(std::span<const Point2> points, const Context& context) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 16384 == 0) context.poll();
    if (!is_finite({points[i].x, points[i].y, 0})) refuse(i);
  }
  return hull_in_plane(planar_hull(points, context));
}

}  // namespace quoin
