// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/closed_surface.h"

#include <algorithm>
#include <numeric>

namespace quoin::io {

namespace {

std::string name_of(const std::array<std::uint32_t, 2>& side) {
  return "the side from " + std::to_string(side[0]) + " to " + std::to_string(side[1]);
}

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

std::size_t corner_count(const std::vector<FaceSide>& sides) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i == 0 || sides[i].corners[0] != sides[i - 1].corners[0]) ++count;
  }
  return count;
}

}  // namespace

std::string why_no_sphere(std::vector<FaceSide>& sides, std::uint32_t faces) {
  std::ranges::sort(sides, {}, &FaceSide::corners);
  const auto again = std::ranges::adjacent_find(sides, {}, &FaceSide::corners);
  if (again != sides.end()) return name_of(again->corners) + " is met twice";
  std::vector<std::uint32_t> parent(faces);
  std::iota(parent.begin(), parent.end(), 0U);
  std::uint32_t pieces = faces;
  for (const FaceSide& side : sides) {
    const std::array<std::uint32_t, 2> back{side.corners[1], side.corners[0]};
    const auto twin = std::ranges::lower_bound(sides, back, {}, &FaceSide::corners);
    if (twin == sides.end() || twin->corners != back) return name_of(side.corners) + " is met one way alone";
    const std::uint32_t a = root_of(parent, side.face);
    const std::uint32_t b = root_of(parent, twin->face);
    if (a == b) continue;
    parent[a] = b;
    --pieces;
  }
  if (pieces != 1) return "it is of " + std::to_string(pieces) + " pieces";
  if (corner_count(sides) + faces != sides.size() / 2 + 2) return "it has handles or corners that touch";
  return "";
}

}  // namespace quoin::io
