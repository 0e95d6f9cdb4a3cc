// SPDX-License-Identifier: Apache-2.0
//
// Hulls of points that are known by rounded doubles and by a table that decides where these leave a sign open.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/hull_builder.h"
#include "quoin/polytope/hull_facets.h"
#include "quoin/polytope/hull_order.h"
#include "quoin/polytope/hull_simplex.h"
#include "quoin/polytope/planar_hull.h"

namespace quoin {

namespace {

class TableHull {
 public:
  TableHull(const Constructions& table, std::span<const PointId> ids, const Context& context)
      : table_(table), ids_(ids), context_(context) {
    rounded_.reserve(ids.size());
    for (const PointId id : ids) {
      if (rounded_.size() % 256 == 0) context.poll();
      const Point3& p = table.rounded(id);
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        throw InputError("point " + std::to_string(rounded_.size()) + " is beyond the range of doubles");
      }
      rounded_.push_back(p);
    }
    simplex_ = find_simplex(rounded_, table, ids, context);
  }

  ConvexHull hull() const {
    if (simplex_.count == 4) return solid();
    if (simplex_.count == 3) return flat();
    ConvexHull hull;
    hull.dimension = static_cast<int>(simplex_.count) - 1;
    hull.vertices.assign(simplex_.points.begin(), simplex_.points.begin() + simplex_.count);
    std::sort(hull.vertices.begin(), hull.vertices.end());
    return hull;
  }

 private:
  ConvexHull solid() const;
  ConvexHull flat() const;
  std::vector<std::uint32_t> all() const {
    std::vector<std::uint32_t> order(ids_.size());
    std::iota(order.begin(), order.end(), 0U);
    return order;
  }

  const Constructions& table_;
  std::span<const PointId> ids_;
  const Context& context_;
  std::vector<Point3> rounded_;
  Simplex simplex_;
};

/// Equal points have equal rounded ones, so the first of them comes first.
ConvexHull TableHull::solid() const {
  std::vector<std::uint32_t> order(simplex_.points.begin(), simplex_.points.end());
  for (const std::uint32_t i : biased_random_order(rounded_, all(), context_).points) {
    if (std::find(simplex_.points.begin(), simplex_.points.end(), i) == simplex_.points.end()) order.push_back(i);
  }
  std::vector<Point3> rounded;
  std::vector<PointId> ids;
  for (const std::uint32_t i : order) {
    if (ids.size() % 256 == 0) context_.poll();
    rounded.push_back(rounded_[i]);
    ids.push_back(ids_[i]);
  }
  HullBuilder builder(rounded, table_, ids, context_);
  for (std::uint32_t i = 4; i < order.size(); ++i) {
    if (i % 64 == 0) context_.poll();
    builder.insert(i);
  }
  return join_facets(builder, order, ids_.size(), context_);
}

/// Projected along the first axis that its normal is not perpendicular to.
ConvexHull TableHull::flat() const {
  std::size_t asked = 0;
  const auto poll_for_some = [&] {
    if (++asked % 256 == 0) context_.poll();
  };
  const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, unsigned axis) {
    poll_for_some();
    return table_.turn_any(ids_[a], ids_[b], ids_[c], axis);
  };
  const auto& [a, b, c, unused] = simplex_.points;
  unsigned axis = 0;
  while (axis < 2 && turn(a, b, c, axis) == Sign::zero) ++axis;
  const unsigned first = (axis + 1) % 3;
  const unsigned second = (axis + 2) % 3;
  const auto order_of = [&](std::uint32_t i, std::uint32_t k) {
    poll_for_some();
    const Sign sign = table_.compare(ids_[i], ids_[k], first);
    return sign != Sign::zero ? sign : table_.compare(ids_[i], ids_[k], second);
  };
  std::vector<std::uint32_t> order = all();
  context_.poll();
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t k) {
    const Sign sign = order_of(i, k);
    return sign != Sign::zero ? sign == Sign::negative : i < k;
  });
  const auto is_equal = [&](std::uint32_t i, std::uint32_t k) { return order_of(i, k) == Sign::zero; };
  order.erase(std::unique(order.begin(), order.end(), is_equal), order.end());
  return hull_of_polygon(planar_hull_of_sorted(
      order, [&](std::uint32_t i, std::uint32_t k, std::uint32_t l) { return turn(i, k, l, axis); }, context_));
}

}  // namespace

ConvexHull convex_hull(const Constructions& table, std::span<const PointId> points, const Context& context) {
  return TableHull(table, points, context).hull();
}

ConvexHull convex_hull(std::span<const RationalPoint3> points, const Context& context) {
  std::vector<RationalPoint3> copies;
  copies.reserve(points.size());
  std::vector<PointId> ids;
  ids.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 256 == 0) context.poll();
    copies.push_back(points[i]);
    ids.push_back(PointId(i));
  }
  const Constructions table(std::move(copies), &context);
  return convex_hull(table, ids, context);
}

/// As points of space of height zero, whose hull is counterclockwise seen from above.
ConvexHull convex_hull(std::span<const RationalPoint2> points, const Context& context) {
  std::vector<RationalPoint3> flat;
  flat.reserve(points.size());
  for (const RationalPoint2& p : points) {
    if (flat.size() % 256 == 0) context.poll();
    flat.push_back({p.x, p.y, Rational(0)});
  }
  ConvexHull hull = convex_hull(flat, context);
  if (hull.dimension < 2) return hull;
  std::vector<std::uint32_t> corners(hull.corners);
  const auto first = std::min_element(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto by_x = points[a].x <=> points[b].x;
    return by_x != 0 ? by_x < 0 : points[a].y < points[b].y;
  });
  std::rotate(corners.begin(), first, corners.end());
  return hull_in_plane(corners);
}

}  // namespace quoin
