// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/polytope/hull_builder.h"

namespace quoin {

/// Leaves out points that are surely inside a hull of few facets, by all its planes: for hulls that are thin and lie
/// askew, of which `HullReach` holds little.
class HullFilter {
 public:
  /// No later point may have a larger coordinate, in magnitude, than `largest_coordinate`.
  HullFilter(const HullBuilder& hull, double largest_coordinate);

  /// Of each step-th point, from begin * step to before end * step: appends those that are not surely inside.
  void append_others(std::span<const Point3> points, std::size_t begin, std::size_t end, std::uint32_t step,
                     std::vector<std::uint32_t>& others) const;

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

  void append_others(Block& block, std::vector<std::uint32_t>& others) const;

  std::vector<HullBuilder::Plane> planes_;  // moved outwards by their slack: inside is below zero
};

}  // namespace quoin
