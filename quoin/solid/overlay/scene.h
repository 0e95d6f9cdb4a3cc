// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/constructions.h"
#include "quoin/solid/leaf.h"

namespace quoin::overlay {

constexpr std::uint32_t none = 0xFFFFFFFFU;

using Corners = std::array<PointId, 3>;

/// A tile that may meet others. Its plane, once set, is the plane of the same index in the table.
struct Facet {
  std::uint32_t tile;  ///< number of the tile in the scene
  std::uint32_t leaf;
  Corners corners;  ///< equal points of all facets share one id
};

/// Two facets whose boxes meet.
struct FacetPair {
  std::uint32_t a;
  std::uint32_t b;
};

/// All leaves in one numbering, and which of their tiles may meet.
///
/// Tiles and vertices of leaf i follow those of leaf i - 1. Facets are the tiles that occur in a candidate pair or at
/// an edge of their leaf without a twin; everything that costs arithmetic is done on facets alone.
struct Scene {
  std::span<const std::shared_ptr<const Leaf>> leaves;
  std::vector<std::uint32_t> first_vertex;  ///< leaf count + 1
  std::vector<std::uint32_t> first_tile;    ///< leaf count + 1
  Constructions table{std::vector<Point3>{}};
  std::vector<Facet> facets;
  std::vector<std::uint32_t> facet_of_tile;  ///< or none
  std::vector<std::uint32_t> merged;         ///< explicit point -> the point that stands for it
  std::vector<bool> shared;                  ///< explicit point that stands for others too
  std::vector<FacetPair> pairs;

  std::size_t tile_count() const { return first_tile.back(); }
  std::uint32_t leaf_of_tile(std::uint32_t tile) const;
  /// Corners of any tile, with merged ids.
  std::array<PointId, 3> corners(std::uint32_t tile, std::uint32_t leaf) const;
  /// Of a face of a leaf's mesh; grey where the leaf has no colours.
  Color color(std::uint32_t leaf, std::uint32_t face) const;
  /// Tile and edge opposite to edge `k` of a tile; tile is none where there is no single opposite one.
  struct Halfedge {
    std::uint32_t tile;
    std::uint32_t edge;
  };
  Halfedge twin(std::uint32_t tile, std::uint32_t edge, std::uint32_t leaf) const;
};

/// Numbers the leaves, finds candidate pairs and merges equal vertices of facets. O(n log n + pairs).
Scene make_scene(std::span<const std::shared_ptr<const Leaf>> leaves, const Context& context);

/// The numbering alone, without facets: enough to count windings.
Scene make_unpaired_scene(std::span<const std::shared_ptr<const Leaf>> leaves, const Context& context);

/// The same of one leaf, which must outlive it, over a table of its points.
Scene make_unpaired_scene(const std::shared_ptr<const Leaf>& leaf, Constructions table);

}  // namespace quoin::overlay
