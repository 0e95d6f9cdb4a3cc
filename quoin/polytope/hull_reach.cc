// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull_reach.h"

#include <limits>

#include "quoin/base/parallel.h"

namespace quoin {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr unsigned most_squares = 12;  // along a side

/// The power of two that brings a length to 1 ... 2, within what can be squared and inverted.
double unit_scale(double length) {
  if (!(length > 0x1p-400 && length < 0x1p400)) return 1;
  return std::ldexp(1, -std::ilogb(length));
}

}  // namespace

/// By how much it must grow to reach centre + d: at most n.d + spare |d|, d in the scaled frame and |d| its largest
/// component.
struct HullReach::Facet {
  std::array<double, 3> n;
  double spare;
};

/// The same on a side of the cube: at a place (u, v) of it.
struct HullReach::Gauge {
  double one;
  double u;
  double v;
  double spare;
  double most = 0;  // in a square
};

HullReach::HullReach(const HullBuilder& hull, double largest_coordinate, const Context& context) {
  set_frame(hull);
  // Bounds grow with the largest coordinate; that of few points may be smaller than that of all.
  const std::vector<Facet> facets =
      facets_from_centre(hull, std::max(1.0, largest_coordinate / hull.largest_coordinate()));
  const auto squares = static_cast<unsigned>(std::sqrt(static_cast<double>(facets.size())) / 6);
  side_cells_ = square_cells * std::clamp(squares, 1U, most_squares);
  half_side_ = side_cells_ / 2.0;
  fill(facets, context);
  inner_ = *std::min_element(reach_.begin(), reach_.end());
  outer_ = *std::max_element(reach_.begin(), reach_.end());
}

/// The mean of the corners of triangles, in which a corner counts once for each. Wherever rounding puts it, what is
/// said of it is true.
void HullReach::set_frame(const HullBuilder& hull) {
  Point3 low{infinity, infinity, infinity};
  Point3 high{-infinity, -infinity, -infinity};
  std::size_t count = 0;
  for (const HullBuilder::Triangle& t : hull.triangles()) count += t.is_free() ? 0 : 3;
  for (const HullBuilder::Triangle& t : hull.triangles()) {
    if (t.is_free()) continue;
    for (const std::uint32_t corner : t.corners) {
      const Point3& p = hull.points()[corner];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        centre_[axis] += p[axis] / static_cast<double>(count);
        low[axis] = std::min(low[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) scale_[axis] = unit_scale(high[axis] / 2 - low[axis] / 2);
}

/// A plane n with offset o, moved inwards by its slack, holds p = c + d if n.d < h = o - slack - n.c; h takes the slack
/// twice more, once for its own rounding (as `HullBuilder` derives it: the evaluation at a point of no larger
/// coordinates) and once to spare.
/// Differences p - c are off by a part of 2^-53 of each component, cells by 2^-50 of the largest, n/h and its products
/// by 2^-50 of the sum of their magnitudes: 2^-38 of that sum pays for all. Powers of two cost nothing: what
/// underflows is far below that, as heights are at least the slack, 2^-120. A facet that the centre is not inside of is
/// refused, and one of numbers that leave the range of doubles.
std::vector<HullReach::Facet> HullReach::facets_from_centre(const HullBuilder& hull, double growth) const {
  std::vector<Facet> facets;
  facets.reserve(hull.triangles().size());
  for (std::uint32_t t = 0; t < hull.triangles().size(); ++t) {
    const HullBuilder::Triangle& triangle = hull.triangles()[t];
    if (triangle.is_free()) continue;
    const HullBuilder::Plane& plane = hull.plane(t);
    const double slack = growth * double{triangle.slack};
    const double height = plane.offset - (plane.x * centre_.x + plane.y * centre_.y + plane.z * centre_.z) - 3 * slack;
    Facet facet{{plane.x / scale_[0] / height, plane.y / scale_[1] / height, plane.z / scale_[2] / height}, 0};
    const double sum = std::fabs(facet.n[0]) + std::fabs(facet.n[1]) + std::fabs(facet.n[2]);
    const bool is_sure = height > 0x1p-900 && sum > 0x1p-200 && sum < 0x1p200;
    if (!is_sure) return {};
    facet.spare = sum * 0x1p-38;
    facets.push_back(facet);
  }
  return facets;
}

/// Squares of a side, and in each the facets that may be the last to be met by a direction of it: those that are, for
/// some corner, higher than another is for all of them. Of these alone the cells of the square take their largest.
void HullReach::fill(const std::vector<Facet>& facets, const Context& context) {
  reach_.assign(std::size_t{6} * side_cells_ * side_cells_, 0);
  if (facets.empty()) return;
  const unsigned squares = side_cells_ / square_cells;
  for_each_chunk(context, std::size_t{6} * squares * squares, 1, [&](const Chunk& chunk) {
    const auto index = static_cast<unsigned>(chunk.begin);
    const unsigned i = index / squares % squares * square_cells;
    const unsigned k = index % squares * square_cells;
    std::vector<Gauge> gauges;
    find_gauges(facets, index / squares / squares, i, k, gauges);
    fill_square(gauges, index / squares / squares, i, k);
  });
}

void HullReach::find_gauges(const std::vector<Facet>& facets, unsigned side, unsigned i, unsigned k,
                            std::vector<Gauge>& gauges) const {
  const unsigned axis = side / 2;
  const std::array<double, 2> u{place(i), place(i + square_cells)};
  const std::array<double, 2> v{place(k), place(k + square_cells)};
  double lower = 0;
  gauges.clear();
  for (const Facet& facet : facets) {
    const Gauge g{side % 2 == 0 ? facet.n[axis] : -facet.n[axis], facet.n[after(axis)], facet.n[after(after(axis))],
                  facet.spare};
    const double most = g.one + std::max(g.u * u[0], g.u * u[1]) + std::max(g.v * v[0], g.v * v[1]) + g.spare;
    if (!(most > lower)) continue;
    const double least = g.one + std::min(g.u * u[0], g.u * u[1]) + std::min(g.v * v[0], g.v * v[1]);
    lower = std::max(lower, least);
    gauges.push_back(g);
    gauges.back().most = most;
  }
  std::erase_if(gauges, [lower](const Gauge& g) { return !(g.most > lower); });
}

void HullReach::fill_square(const std::vector<Gauge>& gauges, unsigned side, unsigned i, unsigned k) {
  constexpr unsigned corners = square_cells + 1;
  std::array<std::array<double, corners>, corners> gauge{};
  std::array<double, corners> v;
  for (unsigned b = 0; b < corners; ++b) v[b] = place(k + b);
  for (const Gauge& g : gauges) {
    for (unsigned a = 0; a < corners; ++a) {
      const double row = g.one + g.spare + g.u * place(i + a);
      for (unsigned b = 0; b < corners; ++b) gauge[a][b] = std::max(gauge[a][b], row + g.v * v[b]);
    }
  }
  for (unsigned a = 0; a < square_cells; ++a) {
    double* const row = &reach_[(std::size_t{side} * side_cells_ + i + a) * side_cells_ + k];
    for (unsigned b = 0; b < square_cells; ++b) {
      row[b] = (1 - 0x1p-40) / std::max({gauge[a][b], gauge[a][b + 1], gauge[a + 1][b], gauge[a + 1][b + 1]});
    }
  }
}

void HullReach::append_others(std::span<const Point3> points, std::size_t begin, std::size_t end, std::uint32_t step,
                              std::vector<std::uint32_t>& others) const {
  for (std::size_t i = begin; i < end; ++i) {
    if (!surely_holds(points[i * step])) others.push_back(static_cast<std::uint32_t>(i * step));
  }
}

}  // namespace quoin
