// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <vector>

#include "quoin/assembly/partition.h"

namespace quoin {

namespace {

struct SampledArc {
  std::uint32_t group;
  std::uint32_t arc;
};

/// Whether the point where the circles of two arcs meet, or the opposite one, is inside both.
bool cross_each_other(const BlockedRegion& a, const BlockedRegion::Arc& first, const BlockedRegion& b,
                      const BlockedRegion::Arc& second) {
  const SphereDirection meeting = cross(first.normal, second.normal);
  if (!meeting.is_valid()) return false;
  const auto is_on = [](const BlockedRegion& region, const BlockedRegion::Arc& arc, const SphereDirection& d) {
    if (arc.source == BlockedRegion::Arc::no_vertex) return true;
    const Sign after = dot_sign(cross(arc.normal, region.vertices[arc.source].at), d);
    const Sign before = dot_sign(cross(region.vertices[arc.target].at, arc.normal), d);
    return after == Sign::positive && before == Sign::positive;
  };
  return (is_on(a, first, meeting) && is_on(b, second, meeting)) ||
         (is_on(a, first, -meeting) && is_on(b, second, -meeting));
}

}  // namespace

/// Pairs of arcs at fixed distances in the list, so that the same input gives the same estimate.
MotionEstimate estimate(std::span<const RegionGroup> groups) {
  MotionEstimate result;
  result.regions = groups.size();
  std::vector<SampledArc> arcs;
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    for (std::uint32_t a = 0; a < groups[g].region.arcs.size(); ++a) arcs.push_back({g, a});
  }
  result.arcs = arcs.size();
  constexpr std::size_t samples = 4096;
  std::uint64_t state = 1;
  const auto next = [&] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::size_t>((state >> 33) % arcs.size());
  };
  std::size_t crossing = 0;
  for (std::size_t k = 0; k < samples && arcs.size() > 1; ++k) {
    const SampledArc a = arcs[next()];
    const SampledArc b = arcs[next()];
    const BlockedRegion& first = groups[a.group].region;
    const BlockedRegion& second = groups[b.group].region;
    crossing += cross_each_other(first, first.arcs[a.arc], second, second.arcs[b.arc]) ? 1U : 0U;
  }
  const auto n = static_cast<double>(arcs.size());
  result.crossings = static_cast<double>(crossing) / static_cast<double>(samples) * n * n / 2;
  // Measured: a sweep makes a million vertices a second, with two edges and a face each, which then are visited.
  result.seconds = (result.crossings + 2 * n) / 1.5e5;
  result.bytes = (result.crossings + 2 * n) * 350;
  return result;
}

}  // namespace quoin
