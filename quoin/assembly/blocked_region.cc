// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/blocked_region.h"

#include <algorithm>
#include <utility>

#include "quoin/assembly/region_extraction.h"
#include "quoin/assembly/region_union.h"

namespace quoin {

namespace {

std::strong_ordering order(const BlockedRegion::Vertex& a, const BlockedRegion::Vertex& b) {
  const std::strong_ordering by_place = compare(a.at, b.at);
  return by_place != 0 ? by_place : a.is_blocked <=> b.is_blocked;
}

std::strong_ordering order(const BlockedRegion::Arc& a, const BlockedRegion::Arc& b) {
  const std::strong_ordering by_normal = compare(a.normal, b.normal);
  if (by_normal != 0) return by_normal;
  return std::tie(a.source, a.target, a.is_slit) <=> std::tie(b.source, b.target, b.is_slit);
}

template <class Item>
std::strong_ordering order_of_lists(const std::vector<Item>& a, const std::vector<Item>& b) {
  if (a.size() != b.size()) return a.size() <=> b.size();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::strong_ordering here = order(a[i], b[i]);
    if (here != 0) return here;
  }
  return std::strong_ordering::equal;
}

/// Of two that are not equal, the closed one within the other.
bool contains(const ConvexRegion& outer, const ConvexRegion& inner) {
  // A lune or hemisphere has no corners that tell what it spans.
  if (inner.corners.size() < 3) return false;
  return std::ranges::all_of(outer.normals, [&](const RegionDirection& n) {
    return std::ranges::all_of(inner.corners,
                               [&](const RegionDirection& corner) { return dot_sign(n, corner) != Sign::negative; });
  });
}

std::vector<ConvexRegion> outermost(std::span<const ConvexRegion> regions) {
  std::vector<ConvexRegion> kept;
  for (const ConvexRegion& region : regions) {
    const bool is_needless = std::ranges::any_of(
        kept, [&](const ConvexRegion& other) { return other == region || contains(other, region); });
    if (is_needless) continue;
    std::erase_if(kept, [&](const ConvexRegion& other) { return contains(region, other); });
    kept.push_back(region);
  }
  return kept;
}

BlockedRegion as_blocked(const ConvexRegion& region) {
  BlockedRegion result;
  const auto count = static_cast<std::uint32_t>(region.corners.size());
  for (const RegionDirection& corner : region.corners) result.vertices.push_back({corner.exact(), false});
  for (std::uint32_t i = 0; i < region.normals.size(); ++i) {
    result.arcs.push_back({region.normals[i].exact(), count == 0 ? BlockedRegion::Arc::no_vertex : i,
                           count == 0 ? BlockedRegion::Arc::no_vertex : (i + 1) % count, false});
  }
  sort_region(result);
  return result;
}

}  // namespace

std::strong_ordering operator<=>(const BlockedRegion& a, const BlockedRegion& b) {
  if (a.blocks_elsewhere != b.blocks_elsewhere) return a.blocks_elsewhere <=> b.blocks_elsewhere;
  const std::strong_ordering by_vertices = order_of_lists(a.vertices, b.vertices);
  return by_vertices != 0 ? by_vertices : order_of_lists(a.arcs, b.arcs);
}

void sort_region(BlockedRegion& region) {
  using Arc = BlockedRegion::Arc;
  std::vector<std::uint32_t> by_place(region.vertices.size());
  for (std::uint32_t v = 0; v < by_place.size(); ++v) by_place[v] = v;
  std::ranges::sort(by_place, [&](std::uint32_t a, std::uint32_t b) {
    return compare(region.vertices[a].at, region.vertices[b].at) == std::strong_ordering::less;
  });
  std::vector<std::uint32_t> place(by_place.size());
  std::vector<BlockedRegion::Vertex> sorted;
  for (const std::uint32_t v : by_place) {
    place[v] = static_cast<std::uint32_t>(sorted.size());
    sorted.push_back(std::move(region.vertices[v]));
  }
  region.vertices = std::move(sorted);
  for (Arc& arc : region.arcs) {
    if (arc.source == Arc::no_vertex) continue;
    arc.source = place[arc.source];
    arc.target = place[arc.target];
  }
  std::ranges::sort(region.arcs, [](const Arc& a, const Arc& b) { return order(a, b) < 0; });
}

BlockedRegion unite(std::span<const ConvexRegion> regions, const Context& context) {
  const std::vector<ConvexRegion> kept = outermost(regions);
  if (kept.empty()) return {};
  if (kept.size() == 1) return as_blocked(kept[0]);
  return extract_region(sweep_union(kept, context));
}

/// A reversed arc turns about the same normal with its sides exchanged; run backwards, the left side is blocked again.
BlockedRegion reflected(const BlockedRegion& region) {
  BlockedRegion result = region;
  for (BlockedRegion::Vertex& vertex : result.vertices) vertex.at = -vertex.at;
  for (BlockedRegion::Arc& arc : result.arcs) {
    if (arc.is_slit) continue;
    arc.normal = -arc.normal;
    std::swap(arc.source, arc.target);
  }
  sort_region(result);
  return result;
}

}  // namespace quoin
