// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/vertex_points.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>

#include "quoin/base/error.h"
#include "quoin/triangulation/spatial_order.h"

namespace quoin {

namespace {

constexpr std::size_t most_points = 150'000'000;  // 2^30 cells

/// Of a coordinate; refuses what is not finite.
double largest_magnitude(std::span<const Point3> points) {
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double size = std::fabs(points[i][axis]);
      if (!(size <= std::numeric_limits<double>::max())) {
        throw InputError("point " + std::to_string(i) + " of the triangulation is not finite");
      }
      largest = std::max(largest, size);
    }
  }
  return largest;
}

/// 1 where a coordinate would be rounded.
double scale_of(std::span<const Point3> points, double largest) {
  const double scale = filter_scale(largest);
  if (scale == 1) return 1;
  return std::ranges::all_of(points, [scale](const Point3& p) { return scales_exactly(p, scale); }) ? scale : 1;
}

Point3 scaled(const Point3& p, double scale) {
  return {p.x * scale + 0.0, p.y * scale + 0.0, p.z * scale + 0.0};  // -0 becomes 0
}

}  // namespace

double filter_scale(double largest) {
  if (largest == 0 || (largest < 0x1p130 && largest > 0x1p-100)) return 1;
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
}

bool scales_exactly(const Point3& p, double scale) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (p[axis] * scale / scale != p[axis]) return false;
  }
  return true;
}

VertexPoints::VertexPoints(std::span<const Point3> list, Scaling scaling, const Context& context) {
  if (list.empty()) throw InputError("a triangulation of no points");
  if (list.size() > most_points) {
    throw InputError("a triangulation takes at most " + std::to_string(most_points) + " points, not " +
                     std::to_string(list.size()));
  }
  const double largest = largest_magnitude(list);
  const double scale = scaling == Scaling::allowed ? scale_of(list, largest) : 1;
  unscale = 1 / scale;
  inputs = hilbert_order(list, context);
  points.reserve(list.size() + 1);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Point3 p = scaled(list[inputs[i]], scale);
    if (points.empty() || !(points.back() == p)) {
      points.push_back(p);
      continue;
    }
    const auto vertex = static_cast<std::uint32_t>(points.size() - 1);
    if (repeated.empty() || repeated.back().vertex != vertex) repeated.push_back({vertex, 0});
    repeated.back().surplus = static_cast<std::uint32_t>(i) - vertex;
  }
}

std::span<const std::uint32_t> VertexPoints::inputs_of(std::uint32_t vertex) const {
  const auto found = std::ranges::lower_bound(repeated, vertex, {}, &Repeated::vertex);
  const std::uint32_t before = found == repeated.begin() ? 0 : std::prev(found)->surplus;
  const bool is_repeated = found != repeated.end() && found->vertex == vertex;
  return {&inputs[vertex + before], is_repeated ? found->surplus - before + 1 : 1};
}

void refuse_for_memory(std::size_t points) {
  throw InputError("too little memory for the triangulation of " + std::to_string(points) + " points: about " +
                   std::to_string(points / 4000 + 1) +
                   " MB where they are spread evenly, and up to the square of their number where they are not");
}

}  // namespace quoin
