// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/clusters.h"

#include <algorithm>
#include <tuple>

#include "quoin/base/disjoint_sets.h"
#include "quoin/kernel/projection.h"

namespace quoin::overlay {

namespace {

class ClusterBuilder {
 public:
  ClusterBuilder(const Scene& scene, std::span<const Edge> met_edges)
      : scene_(scene), met_edges_(met_edges), units_(scene.facets.size()) {}

  Clusters run(std::span<const FacetPair> overlapping) {
    const std::size_t count = scene_.facets.size();
    DisjointSets sets(count);
    result_.is_shared.assign(count, false);
    for (const FacetPair& pair : overlapping) {
      sets.unite(pair.a, pair.b);
      result_.is_shared[pair.a] = result_.is_shared[pair.b] = true;
    }
    result_.of.resize(count);
    result_.is_reversed.assign(count, false);
    for (std::uint32_t f = 0; f < count; ++f) {
      result_.of[f] = sets.find(f);
      if (result_.is_shared[f]) members_.push_back(f);
    }
    for (const std::uint32_t f : members_) {
      result_.is_reversed[f] = is_reversed(f);
      for (std::uint32_t k = 0; k < 3; ++k) join_across(f, k);
    }
    gather_edges();
    return std::move(result_);
  }

 private:
  bool is_reversed(std::uint32_t facet) const {
    const Corners& p = scene_.facets[result_.of[facet]].corners;
    const Corners& q = scene_.facets[facet].corners;
    const unsigned axis = projection_axis(scene_.table, p[0], p[1], p[2]);
    return scene_.table.turn(p[0], p[1], p[2], axis) != scene_.table.turn(q[0], q[1], q[2], axis);
  }

  // The facet on the other side of an edge if it is of the same cluster and mesh face, else none.
  std::uint32_t joined(std::uint32_t facet, std::uint32_t k) const {
    const Facet& f = scene_.facets[facet];
    const Leaf& leaf = *scene_.leaves[f.leaf];
    const std::uint32_t first = scene_.first_tile[f.leaf];
    if (leaf.flat[3 * (f.tile - first) + k] == 0) return none;
    const std::uint32_t tile = scene_.twin(f.tile, k, f.leaf).tile;
    const std::uint32_t other = scene_.facet_of_tile[tile];
    if (other == none || result_.of[other] != result_.of[facet]) return none;
    return leaf.tile_face[tile - first] == leaf.tile_face[f.tile - first] ? other : none;
  }

  void join_across(std::uint32_t facet, std::uint32_t k) {
    const std::uint32_t other = joined(facet, k);
    if (other != none) units_.unite(facet, other);
  }

  void gather_edges() {
    for (const std::uint32_t f : members_) {
      const Corners& corners = scene_.facets[f].corners;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const Edge edge = edge_between(corners[k], corners[(k + 1) % 3]);
        const bool is_inner = joined(f, k) != none && !std::binary_search(met_edges_.begin(), met_edges_.end(), edge);
        (is_inner ? result_.inner_edges : result_.edges).push_back({result_.of[f], edge, units_.find(f)});
      }
    }
    std::sort(result_.edges.begin(), result_.edges.end());
    std::vector<ClusterEdge>& inner = result_.inner_edges;
    std::sort(inner.begin(), inner.end());
    inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
  }

  const Scene& scene_;
  std::span<const Edge> met_edges_;
  Clusters result_;
  DisjointSets units_;
  std::vector<std::uint32_t> members_;
};

}  // namespace

std::span<const ClusterEdge> Clusters::edges_at(std::uint32_t cluster, Edge edge) const {
  const auto key = [](const ClusterEdge& e) { return std::tie(e.cluster, e.edge); };
  const auto first = std::lower_bound(edges.begin(), edges.end(), std::tie(cluster, edge),
                                      [&](const ClusterEdge& e, const auto& k) { return key(e) < k; });
  auto last = first;
  while (last != edges.end() && last->cluster == cluster && last->edge == edge) ++last;
  return {first, last};
}

void windings_across(const Scene& scene, const Clusters& clusters, std::span<const std::uint32_t> covers,
                     std::vector<Winding>& out) {
  out.clear();
  for (const std::uint32_t facet : covers) {
    out.push_back({scene.facets[facet].leaf, clusters.is_reversed[facet] ? -1 : 1});
  }
  if (out.size() == 1) return;
  std::sort(out.begin(), out.end(), [](const Winding& v, const Winding& w) { return v.leaf < w.leaf; });
  auto kept = out.begin();
  for (auto from = out.begin(); from != out.end();) {
    Winding sum{from->leaf, 0};
    for (; from != out.end() && from->leaf == sum.leaf; ++from) sum.number += from->number;
    if (sum.number != 0) *kept++ = sum;
  }
  out.erase(kept, out.end());
}

Clusters make_clusters(const Scene& scene, std::span<const FacetPair> overlapping, std::span<const Edge> met_edges) {
  return ClusterBuilder(scene, met_edges).run(overlapping);
}

}  // namespace quoin::overlay
