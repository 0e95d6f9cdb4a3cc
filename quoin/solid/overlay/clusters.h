// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/solid/overlay/contacts.h"

namespace quoin::overlay {

/// How often a leaf winds about a place, or by how much that changes.
struct Winding {
  std::uint32_t leaf;
  int number;
  friend bool operator==(const Winding&, const Winding&) = default;
};

/// An edge of a facet that shares area with others in its plane.
struct ClusterEdge {
  std::uint32_t cluster;
  Edge edge;
  std::uint32_t unit;  ///< the facet bounded by it, or the smallest of those it is joined with
  friend auto operator<=>(const ClusterEdge&, const ClusterEdge&) = default;
};

/// Facets of one plane that share area, directly or through others, are subdivided together: a cluster, named by its
/// smallest facet. Neighbours in a cluster that stem from one mesh face are one unit, without the edge between them
/// unless a facet of another plane runs along it.
struct Clusters {
  std::vector<std::uint32_t> of;         ///< per facet; itself where it shares no area
  std::vector<bool> is_shared;           ///< per facet: its cluster has others
  std::vector<bool> is_reversed;         ///< per facet: its normal opposes that of the facet that names its cluster
  std::vector<ClusterEdge> edges;        ///< sorted; those of clusters with more than one facet
  std::vector<ClusterEdge> inner_edges;  ///< sorted, unique; edges inside a unit, which the cluster goes without

  std::span<const ClusterEdge> edges_at(std::uint32_t cluster, Edge edge) const;
};

/// By how much winding numbers change from the front of a region to its back, the region turned as the facet that names
/// the cluster: +1 for each facet that covers it, -1 where that has the opposite normal. Ascending by leaf, none of
/// them 0.
void windings_across(const Scene& scene, const Clusters& clusters, std::span<const std::uint32_t> covers,
                     std::vector<Winding>& out);

/// From all pairs that share area, in any order, and the sorted edges along which facets of other planes run. O(n + p
/// log p) for n facets and p pairs.
Clusters make_clusters(const Scene& scene, std::span<const FacetPair> overlapping, std::span<const Edge> met_edges);

}  // namespace quoin::overlay
