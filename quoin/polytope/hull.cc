// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/large_vector.h"
#include "quoin/base/parallel.h"
#include "quoin/polytope/hull_builder.h"
#include "quoin/polytope/hull_facets.h"
#include "quoin/polytope/hull_filter.h"
#include "quoin/polytope/hull_order.h"
#include "quoin/polytope/hull_simplex.h"
#include "quoin/polytope/planar_hull.h"

namespace quoin {

namespace {

/// Below this many points, leaving out those inside costs more than it saves.
constexpr std::size_t many_points = 1000;
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

/// Four of the simplex first, then the others.
std::vector<std::uint32_t> after_simplex(const Simplex& simplex, std::span<const std::uint32_t> others,
                                         const Context& context) {
  std::vector<std::uint32_t> order(simplex.points.begin(), simplex.points.end());
  order.reserve(others.size());
  std::size_t polled = 0;
  for (const std::uint32_t i : others) {
    if (polled++ % 16384 == 0) context.poll();
    if (std::find(simplex.points.begin(), simplex.points.end(), i) == simplex.points.end()) order.push_back(i);
  }
  return order;
}

LargeVector<Point3> gather(std::span<const Point3> points, std::span<const std::uint32_t> order,
                           const Context& context) {
  LargeVector<Point3> result(order.size());
  for_each_chunk(context, order.size(), grain, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) result[i] = points[order[i]];
  });
  return result;
}

/// All points but those that are surely inside the hull of a few, if these are many.
std::vector<std::uint32_t> candidates(std::span<const Point3> points, double largest, const Simplex& simplex,
                                      const Context& context) {
  const LargeVector<Point3> few = gather(points, after_simplex(simplex, extremes(points, context), context), context);
  HullBuilder small(few, context);
  for (std::uint32_t i = 4; i < few.size(); ++i) small.insert(i);
  const HullFilter filter(small, largest);
  std::vector<std::uint32_t> result;
  const auto step = static_cast<std::uint32_t>(points.size() / many_points + 1);
  filter.append_others(points, step, result, context);
  const bool drops_many = 8 * result.size() < 7 * (points.size() / step);
  if (drops_many) {
    result.clear();
    filter.append_others(points, 1, result, context);
  } else {
    result.resize(points.size());
    std::iota(result.begin(), result.end(), 0U);
  }
  return result;
}

/// Of the points that may be corners: the simplex, then rounds of all others.
RandomOrder order_after_simplex(std::span<const Point3> points, double largest, const Simplex& simplex,
                                const Context& context) {
  std::vector<std::uint32_t> chosen(points.size());
  std::iota(chosen.begin(), chosen.end(), 0U);
  if (points.size() >= many_points) chosen = candidates(points, largest, simplex, context);
  RandomOrder order = biased_random_order(points, chosen, context);
  order.points = after_simplex(simplex, order.points, context);
  return order;
}

ConvexHull hull_of_solid(std::span<const Point3> points, double largest, const Simplex& simplex,
                         const Context& context) {
  const auto [order, round_begin] = order_after_simplex(points, largest, simplex, context);
  const LargeVector<Point3> ordered = gather(points, order, context);
  HullBuilder builder(ordered, context);
  builder.reserve(ordered.size());
  for (std::size_t round = 0; round < RandomOrder::rounds; ++round) {
    // Where rounds begin does not matter to a few points, of which four may have been in the simplex.
    const auto begin = std::max<std::size_t>(4, round_begin[round]);
    const auto end = round + 1 == RandomOrder::rounds ? ordered.size() : round_begin[round + 1];
    if (begin < end) builder.insert_many(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), context);
  }
  return join_facets(builder, order, points.size(), context);
}

}  // namespace

ConvexHull convex_hull(std::span<const Point3> points, const Context& context) {
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
