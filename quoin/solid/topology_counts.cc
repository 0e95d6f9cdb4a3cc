// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/topology_counts.h"

#include "quoin/base/disjoint_sets.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace quoin {

namespace {

// A directed edge and the passes (places in loop_vertices) of its two ends.
struct EdgeUse {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t from_pass;
  std::uint32_t to_pass;
};

std::vector<EdgeUse> edge_uses(const Brep& b) {
  std::vector<EdgeUse> uses;
  uses.reserve(b.loop_vertices.size());
  for (std::size_t l = 0; l < b.loop_count(); ++l) {
    if (b.loop(l).size() == 1) continue;
    for (std::uint32_t i = b.loop_begin[l]; i < b.loop_begin[l + 1]; ++i) {
      const std::uint32_t j = i + 1 == b.loop_begin[l + 1] ? b.loop_begin[l] : i + 1;
      uses.push_back({b.loop_vertices[i].value, b.loop_vertices[j].value, i, j});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& x, const EdgeUse& y) {
    const auto key = [](const EdgeUse& e) {
      return std::tuple(std::min(e.from, e.to), std::max(e.from, e.to), e.from > e.to, e.from_pass);
    };
    return key(x) < key(y);
  });
  return uses;
}

}  // namespace

TopologyCounts count_topology(const Brep& boundary) {
  TopologyCounts counts;
  counts.faces = boundary.face_count();
  counts.loops = boundary.loop_count();
  const std::vector<EdgeUse> uses = edge_uses(boundary);
  DisjointSets fans(boundary.loop_vertices.size());
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t j = i;
    std::size_t backward = 0;
    while (j < uses.size() && std::minmax(uses[j].from, uses[j].to) == std::minmax(uses[i].from, uses[i].to)) {
      backward += uses[j].from > uses[j].to ? 1 : 0;
      ++j;
    }
    ++counts.edges;
    if (2 * backward != j - i) ++counts.unbalanced_edges;
    if (j - i > 2) ++counts.nonmanifold_edges;
    if (j - i == 2 && backward == 1) {
      fans.unite(uses[i].from_pass, uses[i + 1].to_pass);
      fans.unite(uses[i].to_pass, uses[i + 1].from_pass);
    }
    i = j;
  }
  std::vector<std::uint32_t> fan_count(boundary.points.point_count(), 0);
  for (std::uint32_t pass = 0; pass < boundary.loop_vertices.size(); ++pass) {
    if (fans.find(pass) == pass) ++fan_count[boundary.loop_vertices[pass].value];
  }
  for (const std::uint32_t fans_here : fan_count) {
    if (fans_here > 0) ++counts.vertices;
    if (fans_here > 1) ++counts.nonmanifold_vertices;
  }
  return counts;
}

Topology topology_of(const Brep& boundary) {
  const TopologyCounts counts = count_topology(boundary);
  Topology topology;
  topology.components = boundary.component_count;
  topology.shells = boundary.shells.size();
  topology.voids = static_cast<std::size_t>(
      std::count_if(boundary.shells.begin(), boundary.shells.end(), [](const Shell& shell) { return shell.is_void; }));
  topology.is_manifold = counts.is_manifold();
  if (topology.is_manifold) {
    const std::size_t left = counts.edges + counts.loops + 2 * topology.shells - counts.vertices - 2 * counts.faces;
    topology.handles = left / 2;
  }
  return topology;
}

}  // namespace quoin
