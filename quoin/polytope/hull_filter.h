// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/polytope/hull_builder.h"

namespace quoin {

/// Leaves out points that are surely inside the hull of a few of them. The error bounds of that hull's planes must hold
/// for all points: none has a larger coordinate than those it was told of.
class HullFilter {
 public:
  HullFilter(const HullBuilder& hull, double largest_coordinate);

  /// Appends first, first + step ... below the number of points, but for those surely inside. O(n), for few planes.
  void append_others(std::span<const Point3> points, std::uint32_t step, std::vector<std::uint32_t>& others,
                     const Context& context) const;

 private:
  static constexpr std::size_t block_size = 64;
  /// Points that wait for the planes, together, so that several are tested at once.
  struct Block {
    std::size_t count = 0;
    std::array<std::uint32_t, block_size> names;
    std::array<double, block_size> x;
    std::array<double, block_size> y;
    std::array<double, block_size> z;
    void add(std::uint32_t name, const Point3& p) {
      names[count] = name;
      x[count] = p.x;
      y[count] = p.y;
      z[count++] = p.z;
    }
  };

  void find_inner_ball(const HullBuilder& hull);
  void append_others(Block& block, std::vector<std::uint32_t>& others) const;

  std::vector<HullBuilder::Plane> planes_;  // moved outwards by their slack: inside is below zero
  Point3 centre_{};
  double squared_radius_ = 0;  // of a ball about the centre that is surely inside, or 0
};

}  // namespace quoin
