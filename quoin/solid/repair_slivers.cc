// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/repair_slivers.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "quoin/base/disjoint_sets.h"
#include "quoin/kernel/predicates2.h"

namespace quoin {

namespace {

using Corners = std::vector<std::uint32_t>;

bool are_collinear(const Point3& a, const Point3& b, const Point3& c) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto project = [k](const Point3& p) { return Point2{p[(k + 1) % 3], p[(k + 2) % 3]}; };
    if (orientation(project(a), project(b), project(c)) != Sign::zero) return false;
  }
  return true;
}

class SliverFinder {
 public:
  SliverFinder(const std::vector<Point3>& vertices, const std::vector<Corners>& faces, const Context& context)
      : vertices_(vertices), faces_(faces), context_(context) {}

  std::vector<std::uint32_t> run() {
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      if (f % 4096 == 0) context_.poll();
      if (is_sliver(faces_[f])) slivers_.push_back(f);
    }
    if (slivers_.empty()) return {};
    count_uses();
    is_dropped_.assign(faces_.size(), false);
    std::vector<std::uint32_t> asked = slivers_;
    while (!asked.empty()) {
      context_.poll();
      asked = drop(asked);
    }
    drop_groups();
    std::sort(dropped_.begin(), dropped_.end());
    return std::move(dropped_);
  }

 private:
  bool is_sliver(const Corners& face) const {
    const bool is_finite = std::all_of(face.begin(), face.end(), [&](std::uint32_t v) {
      return std::isfinite(vertices_[v].x) && std::isfinite(vertices_[v].y) && std::isfinite(vertices_[v].z);
    });
    if (!is_finite) return false;
    const Point3& a = vertices_[face[0]];
    std::size_t other = 1;
    while (other < face.size() && vertices_[face[other]] == a) ++other;
    if (other == face.size()) return true;
    const Point3& b = vertices_[face[other]];
    return std::all_of(face.begin(), face.end(), [&](std::uint32_t v) { return are_collinear(a, b, vertices_[v]); });
  }

  template <class Visitor>
  void for_each_edge(std::uint32_t face, const Visitor& visit) const {
    const Corners& corners = faces_[face];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto [a, b] = std::minmax(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1]);
      visit(std::uint64_t{a} << 32 | b);
    }
  }

  void count_uses() {
    for (const std::uint32_t f : slivers_) {
      for_each_edge(f, [&](std::uint64_t edge) { edges_[edge].slivers.push_back(f); });
    }
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      for_each_edge(f, [&](std::uint64_t edge) {
        const auto at = edges_.find(edge);
        if (at != edges_.end()) ++at->second.uses;
      });
    }
  }

  // Gives the slivers beside those that went.
  std::vector<std::uint32_t> drop(const std::vector<std::uint32_t>& asked) {
    std::vector<std::uint32_t> beside;
    for (const std::uint32_t f : asked) {
      if (is_dropped_[f] || is_needed(f)) continue;
      is_dropped_[f] = true;
      dropped_.push_back(f);
      for_each_edge(f, [&](std::uint64_t edge) {
        Edge& at = edges_.at(edge);
        --at.uses;
        std::erase(at.slivers, f);
        beside.insert(beside.end(), at.slivers.begin(), at.slivers.end());
      });
    }
    std::sort(beside.begin(), beside.end());
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
    return beside;
  }

  // Its own use counts too, so an edge that an odd number of others use has an even number.
  bool is_needed(std::uint32_t face) const {
    std::size_t odd = 0;
    for_each_edge(face, [&](std::uint64_t edge) { odd += 1 - edges_.at(edge).uses % 2; });
    return 2 * odd >= faces_[face].size();
  }

  // Slivers may hold each other in place: those that hang together in edges go where all of these have even use
  // without them, and had not with them.
  void drop_groups() {
    DisjointSets groups(faces_.size());
    for (const auto& [edge, at] : edges_) {
      for (const std::uint32_t f : at.slivers) groups.unite(at.slivers[0], f);
    }
    std::vector<bool> is_odd_with(faces_.size(), false);
    std::vector<bool> is_odd_without(faces_.size(), false);
    for (const auto& [edge, at] : edges_) {
      if (at.slivers.empty()) continue;
      const std::uint32_t group = groups.find(at.slivers[0]);
      if (at.uses % 2 != 0) is_odd_with[group] = true;
      if ((at.uses - at.slivers.size()) % 2 != 0) is_odd_without[group] = true;
    }
    for (const std::uint32_t f : slivers_) {
      const std::uint32_t group = groups.find(f);
      if (!is_dropped_[f] && is_odd_with[group] && !is_odd_without[group]) dropped_.push_back(f);
    }
  }

  struct Edge {
    std::size_t uses = 0;
    std::vector<std::uint32_t> slivers;
  };

  const std::vector<Point3>& vertices_;
  const std::vector<Corners>& faces_;
  const Context& context_;
  std::vector<std::uint32_t> slivers_;
  std::vector<std::uint32_t> dropped_;
  std::vector<bool> is_dropped_;
  std::unordered_map<std::uint64_t, Edge> edges_;  // of slivers
};

}  // namespace

std::vector<std::uint32_t> find_superfluous_slivers(const std::vector<Point3>& vertices,
                                                    const std::vector<Corners>& faces, const Context& context) {
  return SliverFinder(vertices, faces, context).run();
}

}  // namespace quoin
