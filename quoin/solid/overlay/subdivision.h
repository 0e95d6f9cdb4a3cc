// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/overlay/crossings.h"

namespace quoin::overlay {

/// Facets and clusters of facets cut into regions: each region is a polygon, maybe with holes and slits, that no other
/// facet enters.
///
/// Loops are closed chains of vertices with the region on their left, seen from the positive side of the facet's plane.
/// A vertex that touches a region from one side is a loop of its own.
struct Subdivision {
  /// Per region: its facet; of a cluster, one that covers it and has the orientation in which the winding number of the
  /// smallest leaf grows from front to back, so that regions of one surface agree.
  std::vector<std::uint32_t> region_facet;
  std::vector<std::uint32_t> region_first_cover{0};
  std::vector<std::uint32_t> covers;  ///< facets that cover a region, ascending; of each unit the smallest
  std::vector<std::uint32_t> region_first_loop{0};
  std::vector<std::uint32_t> loop_begin{0};
  std::vector<PointId> loop_vertices;

  std::size_t region_count() const { return region_facet.size(); }
  std::span<const std::uint32_t> covers_of(std::size_t region) const {
    return {covers.data() + region_first_cover[region], covers.data() + region_first_cover[region + 1]};
  }
  std::span<const PointId> loop(std::size_t index) const {
    return {loop_vertices.data() + loop_begin[index], loop_begin[index + 1] - loop_begin[index]};
  }
};

/// Cuts every facet that has points or curves, and every cluster. Regions in the order of their facets. O(k log k) per
/// facet with k curve pieces, and O(c k) more for c connected parts of its curves apart from the boundary.
Subdivision subdivide(Scene& scene, const Network& network, std::span<const PointOnCurve> crossings,
                      const Context& context);

}  // namespace quoin::overlay
