// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/subdivision.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "quoin/base/parallel.h"
#include "quoin/solid/overlay/covers.h"
#include "quoin/solid/overlay/facet_graph.h"

namespace quoin::overlay {

namespace {

// Traces the faces of one facet's graph and nests the parts that do not touch its boundary, single nodes among them.
class RegionTracer {
 public:
  RegionTracer(FacetGraph& graph, const Scene& scene, const Clusters& clusters, Subdivision& out)
      : graph_(graph), scene_(scene), table_(scene.table), clusters_(clusters), out_(out) {}

  void run(std::uint32_t facet) {
    const std::array<std::uint32_t, 1> itself{facet};
    trace_cycles();
    find_parts();
    if (part_count_ > 1) nest_parts();
    for (std::uint32_t c = 0; c < cycles_.size(); ++c) {
      if (!cycles_[c].is_outside) emit(facet, itself, c);
    }
  }

  // What no unit covers is not part of the cluster.
  void run_cluster() {
    trace_cycles();
    find_parts();
    nest_parts();
    const Covers covers = find_covers_of_cycles();
    for (std::uint32_t c = 0; c < cycles_.size(); ++c) {
      if (cycles_[c].is_outside || covers.of(c).empty()) continue;
      const std::size_t first_vertex = out_.loop_vertices.size();
      const std::size_t first_loop = out_.loop_begin.size() - 1;
      emit(facing(covers.of(c)), covers.of(c), c);
      if (clusters_.is_reversed[out_.region_facet.back()]) reverse_loops(first_loop, first_vertex);
    }
  }

 private:
  struct Cycle {
    std::uint32_t first;  // halfedge
    std::uint32_t part = 0;
    bool is_outside = false;  // of its part
    std::array<double, 6> box{};
  };
  // What lies inside a cycle and in none that is deeper.
  struct Nested {
    std::uint32_t parent;  // cycle
    std::uint32_t inner;   // cycle or node
    friend auto operator<=>(const Nested&, const Nested&) = default;
  };

  void trace_cycles() {
    const auto halfedges = static_cast<std::uint32_t>(2 * graph_.piece_count());
    cycle_of_.assign(halfedges, none);
    cycles_.clear();
    holes_.clear();
    singles_.clear();
    for (std::uint32_t h = 0; h < halfedges; ++h) {
      if (cycle_of_[h] != none) continue;
      cycles_.push_back({h, 0, graph_.is_outside(h), {}});
      for (std::uint32_t g = h; cycle_of_[g] == none; g = graph_.next(g)) {
        cycle_of_[g] = static_cast<std::uint32_t>(cycles_.size() - 1);
      }
    }
  }

  std::uint32_t root(std::uint32_t n) {
    while (part_[n] != n) n = part_[n] = part_[part_[n]];
    return n;
  }

  // Connected parts of the graph, by union of nodes; part 0 is that of the boundary.
  void find_parts() {
    part_.resize(graph_.node_count());
    std::iota(part_.begin(), part_.end(), 0U);
    part_count_ = graph_.node_count();
    for (std::uint32_t p = 0; p < graph_.piece_count(); ++p) {
      const std::uint32_t a = root(graph_.tail(2 * p));
      const std::uint32_t b = root(graph_.head(2 * p));
      if (a == b) continue;
      part_[std::max(a, b)] = std::min(a, b);
      --part_count_;
    }
  }

  // The lexicographically smallest node of each part, by root.
  std::vector<std::uint32_t> smallest_nodes() {
    std::vector<std::uint32_t> smallest(graph_.node_count(), none);
    for (std::uint32_t n = 0; n < graph_.node_count(); ++n) {
      std::uint32_t& best = smallest[root(n)];
      if (best == none || graph_.less(n, best)) best = n;
    }
    return smallest;
  }

  // At the smallest node of a part all pieces leave into one half plane; left of the last of them is outside.
  std::uint32_t outside_cycle(std::uint32_t node) {
    std::uint32_t last = graph_.leaving(node).front();
    for (const std::uint32_t h : graph_.leaving(node)) {
      if (h != last && graph_.turn(last, h) == Sign::positive) last = h;
    }
    return cycle_of_[last];
  }

  void nest_parts() {
    for (Cycle& cycle : cycles_) {
      cycle.part = root(graph_.tail(cycle.first));
      set_box(cycle);
    }
    std::uint32_t boundary_part = none;
    for (const Cycle& cycle : cycles_) {
      if (cycle.is_outside) boundary_part = cycle.part;
    }
    const std::vector<std::uint32_t> smallest = smallest_nodes();
    around_.assign(graph_.node_count(), {});
    for (std::uint32_t part = 0; part < smallest.size(); ++part) {
      if (smallest[part] == none || part == boundary_part || is_single(part)) continue;
      cycles_[outside_cycle(smallest[part])].is_outside = true;
    }
    for (std::uint32_t part = 0; part < smallest.size(); ++part) {
      if (smallest[part] == none || part == boundary_part) continue;
      for (std::uint32_t c = 0; c < cycles_.size(); ++c) {
        if (!cycles_[c].is_outside && cycles_[c].part != part && contains(c, smallest[part]))
          around_[part].push_back(c);
      }
    }
    for (std::uint32_t c = 0; c < cycles_.size(); ++c) {
      if (cycles_[c].is_outside && cycles_[c].part != boundary_part && !around_[cycles_[c].part].empty())
        holes_.push_back({innermost(cycles_[c].part), c});
    }
    for (std::uint32_t n = 0; n < graph_.node_count(); ++n) {
      if (is_single(n) && !around_[n].empty()) singles_.push_back({innermost(n), n});
    }
    std::sort(holes_.begin(), holes_.end());
    std::sort(singles_.begin(), singles_.end());
  }

  // A node without pieces is a part of its own.
  bool is_single(std::uint32_t node) const { return graph_.leaving(node).empty(); }

  void set_box(Cycle& cycle) {
    cycle.box = {1e308, 1e308, 1e308, -1e308, -1e308, -1e308};
    std::uint32_t h = cycle.first;
    do {
      const Point3& p = table_.rounded(graph_.node(graph_.tail(h)));
      for (std::size_t k = 0; k < 3; ++k) {
        cycle.box[k] = std::min(cycle.box[k], p[k]);
        cycle.box[k + 3] = std::max(cycle.box[k + 3], p[k]);
      }
      h = graph_.next(h);
    } while (h != cycle.first);
  }

  bool contains(std::uint32_t c, std::uint32_t node) {
    const Cycle& cycle = cycles_[c];
    const Point3& p = table_.rounded(graph_.node(node));
    for (std::size_t k = 0; k < 3; ++k) {
      if (p[k] < cycle.box[k] || p[k] > cycle.box[k + 3]) return false;
    }
    bool inside = false;
    std::uint32_t h = cycle.first;
    do {
      if (graph_.ray_crosses(node, h)) inside = !inside;
      h = graph_.next(h);
    } while (h != cycle.first);
    return inside;
  }

  // Of the cycles around a part, the one whose own part lies deepest.
  std::uint32_t innermost(std::uint32_t part) {
    const auto& candidates = around_[part];
    return *std::max_element(candidates.begin(), candidates.end(), [&](std::uint32_t c, std::uint32_t d) {
      return around_[cycles_[c].part].size() < around_[cycles_[d].part].size();
    });
  }

  static std::span<const Nested> inside(const std::vector<Nested>& all, std::uint32_t cycle) {
    const auto first = std::lower_bound(all.begin(), all.end(), Nested{cycle, 0});
    auto last = first;
    while (last != all.end() && last->parent == cycle) ++last;
    return {first, last};
  }

  std::uint32_t facing(std::span<const std::uint32_t> covers) {
    windings_across(scene_, clusters_, covers, across_);
    const bool reversed = !across_.empty() && across_[0].number < 0;
    return *std::find_if(covers.begin(), covers.end(),
                         [&](std::uint32_t f) { return across_.empty() || clusters_.is_reversed[f] == reversed; });
  }

  void reverse_loops(std::size_t first_loop, std::size_t first_vertex) {
    auto begin = out_.loop_vertices.begin() + static_cast<std::ptrdiff_t>(first_vertex);
    for (std::size_t l = first_loop; l + 1 < out_.loop_begin.size(); ++l) {
      const auto end = out_.loop_vertices.begin() + out_.loop_begin[l + 1];
      std::reverse(begin, end);
      begin = end;
    }
  }

  // A region is named by its outer cycle; one past the last is what lies outside of everything.
  Covers find_covers_of_cycles() const {
    const auto outside = static_cast<std::uint32_t>(cycles_.size());
    std::vector<std::uint32_t> region(cycles_.size());
    for (std::uint32_t c = 0; c < cycles_.size(); ++c) region[c] = cycles_[c].is_outside ? outside : c;
    for (const auto& [parent, hole] : holes_) region[hole] = parent;
    std::vector<RegionNeighbours> neighbours;
    for (std::uint32_t p = 0; p < graph_.piece_count(); ++p) {
      neighbours.push_back({region[cycle_of_[2 * p]], region[cycle_of_[2 * p + 1]], graph_.units_at(p)});
    }
    return find_covers(outside + 1, outside, neighbours);
  }

  void emit(std::uint32_t facet, std::span<const std::uint32_t> covers, std::uint32_t cycle) {
    emit_loop(cycles_[cycle]);
    for (const auto& [parent, hole] : inside(holes_, cycle)) emit_loop(cycles_[hole]);
    for (const auto& [parent, node] : inside(singles_, cycle)) {
      out_.loop_vertices.push_back(graph_.node(node));
      end_loop();
    }
    out_.region_facet.push_back(facet);
    out_.covers.insert(out_.covers.end(), covers.begin(), covers.end());
    out_.region_first_cover.push_back(static_cast<std::uint32_t>(out_.covers.size()));
    out_.region_first_loop.push_back(static_cast<std::uint32_t>(out_.loop_begin.size() - 1));
  }

  void emit_loop(const Cycle& cycle) {
    std::uint32_t h = cycle.first;
    do {
      out_.loop_vertices.push_back(graph_.node(graph_.tail(h)));
      h = graph_.next(h);
    } while (h != cycle.first);
    end_loop();
  }

  void end_loop() { out_.loop_begin.push_back(static_cast<std::uint32_t>(out_.loop_vertices.size())); }

  FacetGraph& graph_;
  const Scene& scene_;
  const Constructions& table_;
  const Clusters& clusters_;
  Subdivision& out_;
  std::vector<Winding> across_;
  std::vector<Cycle> cycles_;
  std::vector<std::uint32_t> cycle_of_;
  std::vector<std::uint32_t> part_;
  std::size_t part_count_ = 0;
  std::vector<std::vector<std::uint32_t>> around_;  // per part: cycles that contain it
  std::vector<Nested> holes_;                       // sorted; cycles that are the outside of their part
  std::vector<Nested> singles_;                     // sorted; nodes without pieces
};

void append(Subdivision& all, const Subdivision& part) {
  const auto loops = static_cast<std::uint32_t>(all.loop_begin.size() - 1);
  const auto vertices = static_cast<std::uint32_t>(all.loop_vertices.size());
  const auto covers = static_cast<std::uint32_t>(all.covers.size());
  for (std::size_t i = 1; i < part.region_first_cover.size(); ++i) {
    all.region_first_cover.push_back(part.region_first_cover[i] + covers);
  }
  all.covers.insert(all.covers.end(), part.covers.begin(), part.covers.end());
  all.region_facet.insert(all.region_facet.end(), part.region_facet.begin(), part.region_facet.end());
  for (std::size_t i = 1; i < part.region_first_loop.size(); ++i) {
    all.region_first_loop.push_back(part.region_first_loop[i] + loops);
  }
  for (std::size_t i = 1; i < part.loop_begin.size(); ++i) all.loop_begin.push_back(part.loop_begin[i] + vertices);
  all.loop_vertices.insert(all.loop_vertices.end(), part.loop_vertices.begin(), part.loop_vertices.end());
}

// Where chunks of facets begin, and the end: of about as many curves each, since one facet may be cut by thousands.
std::vector<std::size_t> chunk_begins(std::span<const std::uint32_t> facets, const Network& network) {
  constexpr std::size_t weight_of_facet = 4;
  constexpr std::size_t weight_of_chunk = 512;
  std::vector<std::size_t> begins;
  std::size_t weight = weight_of_chunk;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (weight >= weight_of_chunk) {
      begins.push_back(i);
      weight = 0;
    }
    weight += weight_of_facet + network.curves_in(facets[i]).size();
  }
  begins.push_back(facets.size());
  return begins;
}

}  // namespace

Subdivision subdivide(Scene& scene, const Network& network, std::span<const PointOnCurve> crossings,
                      const Context& context) {
  std::vector<std::uint32_t> facets;
  for (std::uint32_t f = 0; f < scene.facets.size(); ++f) {
    if (network.cut[f] && network.clusters.of[f] == f) facets.push_back(f);
  }
  scene.table.resize_lines(network.curves.size() + 3 * facets.size());
  context.progress("subdivision", 0);
  const std::vector<std::size_t> begins = chunk_begins(facets, network);
  std::vector<Subdivision> parts(begins.size() - 1);
  for_each_chunk(context, parts.size(), 1, [&](const Chunk& chunk) {
    FacetGraph graph(scene, network, crossings);
    RegionTracer tracer(graph, scene, network.clusters, parts[chunk.index]);
    for (std::size_t i = begins[chunk.index]; i < begins[chunk.index + 1]; ++i) {
      graph.build(facets[i], network.curves.size() + 3 * i);
      if (network.clusters.is_shared[facets[i]]) {
        tracer.run_cluster();
      } else {
        tracer.run(facets[i]);
      }
    }
  });
  Subdivision result;
  for (const Subdivision& part : parts) append(result, part);
  return result;
}

}  // namespace quoin::overlay
