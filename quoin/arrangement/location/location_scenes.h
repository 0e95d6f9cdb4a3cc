// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/arrangement/linear/linear_arrangement.h"

namespace quoin {

/// An arrangement and points to look for in it, for tests.
struct Scene {
  std::string name;
  LinearArrangement arrangement;
  std::vector<LinearPoint> queries;
};

/// Small arrangements full of equal x, common ends and lines through one point, with queries on every vertex, in the
/// middle of every edge, beside both, on a lattice and anywhere.
const std::vector<Scene>& location_scenes();

/// Segments with random ends, of about the given length in the unit square; no two ends share an x.
LinearArrangement random_segments(std::size_t count, double length, unsigned seed);

}  // namespace quoin
