// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

/// Scenes that tests of circles share.
namespace quoin::testing {

/// Centres and radii.
using CircleScene = std::vector<std::array<int, 3>>;

/// Book on arrangements, the figure of 14 circles with 59 vertices, 106 edges and 53 faces; integer replacements with
/// the same counts, with tangent pairs, triple points and extremes on other circles.
inline const std::vector<CircleScene>& scenes_of_14_circles() {
  static const std::vector<CircleScene> scenes{{{-1, -1, 5},
                                                {0, 7, 2},
                                                {2, 9, 2},
                                                {4, 8, 1},
                                                {5, 7, 4},
                                                {5, 10, 5},
                                                {6, 4, 5},
                                                {6, 8, 3},
                                                {7, 8, 2},
                                                {11, 13, 1},
                                                {12, 7, 1},
                                                {14, 8, 9},
                                                {16, 11, 1},
                                                {18, 6, 2}},
                                               {{-9, 2, 3},
                                                {-2, 13, 5},
                                                {-1, 10, 1},
                                                {2, 5, 1},
                                                {4, 6, 1},
                                                {5, 9, 3},
                                                {7, 5, 1},
                                                {7, 9, 3},
                                                {8, 6, 5},
                                                {8, 9, 4},
                                                {9, 7, 2},
                                                {9, 9, 1},
                                                {11, 6, 4},
                                                {12, 7, 1}},
                                               {{-6, 2, 2},
                                                {-2, 2, 7},
                                                {-2, 9, 4},
                                                {0, 2, 2},
                                                {1, 9, 1},
                                                {2, 10, 2},
                                                {4, 6, 3},
                                                {5, 1, 1},
                                                {5, 6, 2},
                                                {5, 6, 4},
                                                {5, 9, 5},
                                                {7, 9, 3},
                                                {11, 0, 3},
                                                {11, 0, 4}}};
  return scenes;
}

}  // namespace quoin::testing
