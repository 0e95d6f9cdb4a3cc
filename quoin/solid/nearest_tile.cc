// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/nearest_tile.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "quoin/kernel/closest_point.h"

namespace quoin {

namespace {

using Corners = std::array<PointId, 3>;

/// Below the distance of a point from the box of a tile, by rounded coordinates. Those of the point and of the corners
/// err by u of themselves, differences and the root by a few u more; 2^-1000 pays for what falls below the range of
/// doubles. Where squares would, the largest gap has to do.
double least_distance(const Point3& p, const Constructions& table, const Corners& corners) {
  double sum = 0;
  double largest_gap = 0;
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = table.rounded(corners[0])[axis];
    double high = low;
    for (std::size_t k = 1; k < 3; ++k) {
      low = std::min(low, table.rounded(corners[k])[axis]);
      high = std::max(high, table.rounded(corners[k])[axis]);
    }
    const double gap = std::max({low - p[axis], p[axis] - high, 0.0});
    sum += gap * gap;
    largest_gap = std::max(largest_gap, gap);
    size = std::max({size, std::fabs(low), std::fabs(high), std::fabs(p[axis])});
  }
  const double distance = sum > 0x1p-900 ? std::sqrt(sum) : largest_gap;
  const double least = distance * (1 - 0x1p-48) - size * 0x1p-48 - 0x1p-1000;
  return least > 0 && std::isfinite(least) ? least : 0;
}

NearestPoint nearest_of_tile(const RationalPoint3& p, const Constructions& table, const Corners& corners) {
  std::array<closest::Vector<Rational>, 3> triangle;
  for (std::size_t k = 0; k < 3; ++k) {
    const RationalPoint3 d = table.exact(corners[k]) - p;
    triangle[k] = {d.x, d.y, d.z};
  }
  const auto normal =
      closest::cross(closest::difference(triangle[1], triangle[0]), closest::difference(triangle[2], triangle[0]));
  const auto found = closest::on_polygon<Rational>(std::span<const closest::Vector<Rational>>(triangle), normal);
  RationalPoint3 nearest = p;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto& [x, y, z] = triangle[found.corners[j]];
    nearest = nearest + RationalPoint3{x, y, z} * found.weights[j];
  }
  return {found.squared_length, nearest, 0};
}

}  // namespace

std::optional<NearestPoint> nearest_point(const RationalPoint3& point, const Constructions& table,
                                          std::span<const Corners> tiles, TouchingTiles touching,
                                          const Context& context) {
  const Point3 rounded{point.x.to_double(), point.y.to_double(), point.z.to_double()};
  std::vector<std::pair<double, std::uint32_t>> order;
  order.reserve(tiles.size());
  for (std::uint32_t t = 0; t < tiles.size(); ++t) order.push_back({least_distance(rounded, table, tiles[t]), t});
  // A heap: only the first few are taken out in order.
  std::make_heap(order.begin(), order.end(), std::greater<>());
  std::optional<NearestPoint> nearest;
  for (auto end = order.end(); end != order.begin(); --end) {
    context.poll();
    std::pop_heap(order.begin(), end, std::greater<>());
    const auto& [least, tile] = *(end - 1);
    if (nearest && Rational(least) * Rational(least) > nearest->squared_distance) break;
    NearestPoint found = nearest_of_tile(point, table, tiles[tile]);
    if (touching == TouchingTiles::are_left_out && found.squared_distance.sign() == Sign::zero) continue;
    if (nearest && !(found.squared_distance < nearest->squared_distance)) continue;
    nearest = std::move(found);
    nearest->tile = tile;
  }
  return nearest;
}

}  // namespace quoin
