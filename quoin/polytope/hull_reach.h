// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/polytope/hull_builder.h"

namespace quoin {

/// How far a hull surely reaches from a point inside it, for each cell of directions: a cube about the point with
/// square cells on its sides. The gauge of a convex body (by how much it must grow to reach a point) is convex, so on a
/// cell it is largest at a corner, and there it is the largest of those of the facets' planes. One product then tells
/// of most points that they are inside, however many facets there are.
class HullReach {
 public:
  /// O(number of facets). No later point may have a larger coordinate, in magnitude, than `largest_coordinate`.
  /// @throws Cancelled
  HullReach(const HullBuilder& hull, double largest_coordinate, const Context& context);

  /// Of each step-th point, from begin * step to before end * step: appends those that are not surely inside.
  void append_others(std::span<const Point3> points, std::size_t begin, std::size_t end, std::uint32_t step,
                     std::vector<std::uint32_t>& others) const;

  /// False where it is not sure.
  bool surely_holds(const Point3& p) const {
    const std::array<double, 3> d{(p.x - centre_.x) * scale_[0], (p.y - centre_.y) * scale_[1],
                                  (p.z - centre_.z) * scale_[2]};
    const std::array<double, 3> size{std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2])};
    const double most = std::max({size[0], size[1], size[2]});
    if (most < inner_) return true;
    if (!(most < outer_)) return false;
    const unsigned axis = size[0] == most ? 0 : size[1] == most ? 1 : 2;
    const double cells = half_side_ / most;
    const unsigned i = cell(d[after(axis)], cells);
    const unsigned k = cell(d[after(after(axis))], cells);
    const unsigned side = 2 * axis + (d[axis] < 0 ? 1 : 0);
    return most < reach_[(side * side_cells_ + i) * side_cells_ + k];
  }

 private:
  struct Facet;
  struct Gauge;
  static constexpr unsigned square_cells = 8;  // along each side of a square

  static unsigned after(unsigned axis) { return axis == 2 ? 0 : axis + 1; }
  unsigned cell(double d, double cells) const {
    return std::min(static_cast<unsigned>(d * cells + half_side_), side_cells_ - 1);
  }
  void set_frame(const HullBuilder& hull);
  std::vector<Facet> facets_from_centre(const HullBuilder& hull, double growth) const;
  double place(unsigned i) const { return (i - half_side_) / half_side_; }
  void fill(const std::vector<Facet>& facets, const Context& context);
  void find_gauges(const std::vector<Facet>& facets, unsigned side, unsigned i, unsigned k,
                   std::vector<Gauge>& gauges) const;
  void fill_square(const std::vector<Gauge>& gauges, unsigned side, unsigned i, unsigned k);

  Point3 centre_{};
  std::array<double, 3> scale_{1, 1, 1};  // powers of two, so that the hull is about as large along each axis
  unsigned side_cells_ = square_cells;
  double half_side_ = square_cells / 2;  // in cells
  double inner_ = 0;                     // least and largest reach
  double outer_ = 0;
  std::vector<double> reach_;  // of each cell; 0 if nothing is sure
};

}  // namespace quoin
