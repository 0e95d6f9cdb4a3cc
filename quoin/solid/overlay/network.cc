// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/network.h"

#include <algorithm>
#include <tuple>

#include "quoin/base/error.h"
#include "quoin/base/parallel.h"
#include "quoin/base/parallel_sort.h"

namespace quoin::overlay {

namespace {

// A plane through an edge parallel to an axis.
struct AxisPlane {
  Edge edge;
  std::uint32_t axis;
  friend auto operator<=>(const AxisPlane&, const AxisPlane&) = default;
};

template <class T>
void sort_unique(std::vector<T>& list, const Context& context) {
  sort_parallel(context, list);
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

template <class T>
std::size_t rank_in(const std::vector<T>& sorted, const T& value) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

class NetworkBuilder {
 public:
  NetworkBuilder(Scene& scene, const Context& context)
      : scene_(scene), context_(context), network_{{}, {}, {}, {}, {}, {}, PointMerger(scene.table)} {}

  Network run() {
    intersect_pairs();
    number_contacts();
    cluster_facets();
    mark_facets();
    set_facet_planes();
    set_axis_planes();
    construct_contacts();
    merge_points();
    collect_points();
    collect_curves();
    return std::move(network_);
  }

 private:
  void intersect_pairs() {
    constexpr std::size_t grain = 1024;
    found_.resize(chunk_count(scene_.pairs.size(), grain));
    context_.progress("contacts", 0);
    for_each_chunk(context_, scene_.pairs.size(), grain, [&](const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) find_contacts(scene_, scene_.pairs[i], found_[chunk.index]);
    });
  }

  // Everything of a kind that pairs report. Repetitions are mostly within one chunk, where they are cheap to drop.
  template <class T, class Select>
  std::vector<T> gather_unique(const Select& select) const {
    std::vector<std::vector<T>> parts(found_.size());
    for_each_chunk(context_, found_.size(), 1, [&](const Chunk& chunk) {
      std::vector<T>& part = parts[chunk.index];
      part = select(found_[chunk.index]);
      std::sort(part.begin(), part.end());
      part.erase(std::unique(part.begin(), part.end()), part.end());
    });
    std::vector<T> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    sort_unique(all, context_);
    return all;
  }

  void number_contacts() {
    keys_ = gather_unique<ContactKey>([](const Contacts& part) -> const auto& { return part.keys; });
    first_contact_ = scene_.table.point_count();
    ids_.resize(found_.size());
    for_each_chunk(context_, found_.size(), 1, [&](const Chunk& chunk) {
      for (const ContactKey& key : found_[chunk.index].keys) {
        ids_[chunk.index].push_back(PointId{first_contact_ + rank_in(keys_, key)});
      }
    });
    context_.poll();
  }

  void cluster_facets() {
    std::vector<FacetPair> overlapping;
    for (const Contacts& part : found_) {
      overlapping.insert(overlapping.end(), part.overlapping.begin(), part.overlapping.end());
    }
    std::vector<Edge> met_edges;
    if (!overlapping.empty()) {
      met_edges = gather_unique<Edge>([](const Contacts& part) -> const auto& { return part.met_edges; });
    }
    network_.clusters = make_clusters(scene_, overlapping, met_edges);
  }

  PointId id_of(std::size_t part, PointRef ref) const {
    return ref.is_contact() ? ids_[part][ref.contact_index()] : PointId{ref.value};
  }

  // Edges with a point inside. Of the contacts, the first edges are sorted already.
  std::vector<Edge> gather_cut_edges() const {
    std::vector<Edge> edges;
    for (const ContactKey& key : keys_) {
      const Edge first{key.a, key.b};
      if (edges.empty() || edges.back() != first) edges.push_back(first);
    }
    for (const ContactKey& key : keys_) {
      if (key.d != none) edges.push_back({key.c, key.d});
    }
    for (const Contacts& part : found_) {
      for (const PointOnEdge& p : part.edge_points) edges.push_back(p.edge);
    }
    sort_unique(edges, context_);
    return edges;
  }

  // Facets with points on their boundary or inside are cut; with an edge that others may share, they are involved.
  void mark_facets() {
    const std::vector<Edge> cut_edges = gather_cut_edges();
    network_.cut = network_.clusters.is_shared;
    network_.involved.assign(scene_.facets.size(), false);
    for (const Contacts& part : found_) {
      for (const PointInFacet& p : part.facet_points) network_.cut[p.facet] = true;
      for (const Trace& t : part.traces) network_.cut[t.facet] = true;
      for (const FacetPair& p : part.adjoining) network_.involved[p.a] = network_.involved[p.b] = true;
    }
    for (const ContactKey& key : keys_) {
      if (key.d == none) network_.cut[key.c] = true;
    }
    for (std::size_t f = 0; f < scene_.facets.size(); ++f) {
      const Facet& facet = scene_.facets[f];
      for (std::size_t k = 0; k < 3; ++k) {
        const PointId p = facet.corners[k];
        const PointId q = facet.corners[(k + 1) % 3];
        if (std::binary_search(cut_edges.begin(), cut_edges.end(), edge_between(p, q))) network_.cut[f] = true;
        const bool alone = scene_.twin(facet.tile, static_cast<std::uint32_t>(k), facet.leaf).tile == none;
        if (alone || (scene_.shared[p.value] && scene_.shared[q.value])) network_.involved[f] = true;
      }
      if (network_.cut[f]) network_.involved[f] = true;
    }
  }

  void set_facet_planes() {
    std::vector<bool> needed = network_.involved;
    for (const ContactKey& key : keys_) {
      if (key.d == none) needed[key.c] = true;
    }
    for (const Contacts& part : found_) {
      for (const Trace& t : part.traces) needed[t.cutter] = true;
    }
    Constructions& table = scene_.table;
    table.resize_planes(scene_.facets.size());
    for_each_chunk(context_, scene_.facets.size(), 512, [&](const Chunk& chunk) {
      for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
        const auto& c = scene_.facets[f].corners;
        if (needed[f]) table.set_plane(PlaneId{f}, c[0], c[1], c[2]);
      }
    });
  }

  // Two edges that cross: the plane through the second along an axis in whose projection they are not parallel.
  AxisPlane plane_through_second(const ContactKey& key) const {
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      if (scene_.table.turn(PointId{key.a}, PointId{key.b}, PointId{key.c}, axis) != Sign::zero) {
        return {{key.c, key.d}, axis};
      }
    }
    throw InternalError("two collinear edges were said to cross");
  }

  AxisPlane plane_of_edge(const ClusterEdge& e) const { return {e.edge, scene_.table.main_axis(PlaneId{e.cluster})}; }

  PlaneId id_of(const AxisPlane& plane) const { return PlaneId{scene_.facets.size() + rank_in(axis_planes_, plane)}; }

  void set_axis_planes() {
    for (const ContactKey& key : keys_) {
      if (key.d != none) axis_planes_.push_back(plane_through_second(key));
    }
    for (const ClusterEdge& e : network_.clusters.edges) axis_planes_.push_back(plane_of_edge(e));
    sort_unique(axis_planes_, context_);
    Constructions& table = scene_.table;
    table.resize_planes(scene_.facets.size() + axis_planes_.size());
    for_each_chunk(context_, axis_planes_.size(), 512, [&](const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const AxisPlane& plane = axis_planes_[i];
        table.set_axis_plane(PlaneId{scene_.facets.size() + i}, PointId{plane.edge.a}, PointId{plane.edge.b},
                             plane.axis);
      }
    });
  }

  void construct_contacts() {
    Constructions& table = scene_.table;
    if (first_contact_ + keys_.size() >= PointRef::contact_bit) throw InputError("too many intersections");
    table.resize_points(first_contact_ + keys_.size());
    for_each_chunk(context_, keys_.size(), 256, [&](const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const ContactKey& key = keys_[i];
        const PlaneId plane = key.d == none ? PlaneId{key.c} : id_of(plane_through_second(key));
        table.set_point(PointId{first_contact_ + i}, PointId{key.a}, PointId{key.b}, plane);
      }
    });
  }

  void merge_points() {
    std::vector<std::uint32_t> corners;
    for (std::size_t f = 0; f < scene_.facets.size(); ++f) {
      if (!network_.involved[f]) continue;
      for (const PointId p : scene_.facets[f].corners) corners.push_back(p.value);
    }
    // Vertices that only touch an edge or a facet: their own facets may have no part in this.
    for (const Contacts& part : found_) {
      for (const PointOnEdge& p : part.edge_points) corners.push_back(p.point.value);
      for (const PointInFacet& p : part.facet_points) corners.push_back(p.point.value);
    }
    sort_unique(corners, context_);
    for (const std::uint32_t p : corners) network_.merger.insert(PointId{p});
    canonical_.resize(keys_.size());
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      if (i % 4096 == 0) context_.poll();
      canonical_[i] = network_.merger.insert(PointId{first_contact_ + i});
    }
  }

  PointId canonical(PointId p) const { return p.value >= first_contact_ ? canonical_[p.value - first_contact_] : p; }

  void collect_points() {
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      const ContactKey& key = keys_[i];
      network_.edge_points.push_back({{key.a, key.b}, canonical_[i]});
      if (key.d == none) {
        network_.facet_points.push_back({network_.clusters.of[key.c], canonical_[i]});
      } else {
        network_.edge_points.push_back({{key.c, key.d}, canonical_[i]});
      }
    }
    for (const Contacts& part : found_) {
      network_.edge_points.insert(network_.edge_points.end(), part.edge_points.begin(), part.edge_points.end());
      for (const PointInFacet& p : part.facet_points) {
        network_.facet_points.push_back({network_.clusters.of[p.facet], p.point});
      }
    }
    sort_unique(network_.edge_points, context_);
    add_points_on_inner_edges();
    sort_unique(network_.facet_points, context_);
  }

  // Where no curve ends, they touch the cluster from one side. An end of such an edge lies inside the unit where a
  // vertex touches the mesh face.
  void add_points_on_inner_edges() {
    for (const ClusterEdge& e : network_.clusters.inner_edges) {
      for (const std::uint32_t end : {e.edge.a, e.edge.b}) network_.facet_points.push_back({e.cluster, PointId{end}});
      for (const PointOnEdge& p : network_.points_on(e.edge)) network_.facet_points.push_back({e.cluster, p.point});
    }
  }

  // A wall that stands on a cluster along an edge that the cluster has anyway.
  bool is_edge_of_cluster(const Trace& t) const {
    const Clusters& clusters = network_.clusters;
    return t.edge.a != none && clusters.is_shared[t.facet] && !clusters.edges_at(clusters.of[t.facet], t.edge).empty();
  }

  void collect_curves() {
    std::vector<Curve>& curves = network_.curves;
    for (std::size_t part = 0; part < found_.size(); ++part) {
      for (const Trace& t : found_[part].traces) {
        if (is_edge_of_cluster(t)) continue;
        PointId from = canonical(id_of(part, t.from));
        PointId to = canonical(id_of(part, t.to));
        if (from == to) continue;
        if (to < from) std::swap(from, to);
        curves.push_back({network_.clusters.of[t.facet], from, to, PlaneId{t.cutter}, Edge{none, none}});
      }
    }
    for (const ClusterEdge& e : network_.clusters.edges) {
      curves.push_back({e.cluster, PointId{e.edge.a}, PointId{e.edge.b}, id_of(plane_of_edge(e)), e.edge});
    }
    const auto place = [](const Curve& c) { return std::tuple(c.facet, c.from, c.to); };
    sort_parallel(context_, curves, [&](const Curve& x, const Curve& y) {
      const auto rest = [](const Curve& c) { return std::tuple(!c.is_along_edge(), c.cut); };
      return std::tuple_cat(place(x), rest(x)) < std::tuple_cat(place(y), rest(y));
    });
    curves.erase(
        std::unique(curves.begin(), curves.end(), [&](const Curve& x, const Curve& y) { return place(x) == place(y); }),
        curves.end());
  }

  Scene& scene_;
  const Context& context_;
  Network network_;
  std::vector<Contacts> found_;            // per chunk of pairs
  std::vector<std::vector<PointId>> ids_;  // of the contacts of each chunk
  std::vector<ContactKey> keys_;           // sorted; contact i is point first_contact_ + i
  std::vector<PointId> canonical_;         // per contact
  std::vector<AxisPlane> axis_planes_;     // sorted; their planes follow those of the facets
  std::size_t first_contact_ = 0;
};

}  // namespace

std::span<const PointOnEdge> Network::points_on(Edge edge) const {
  const auto less = [](const auto& x, const auto& y) {
    if constexpr (requires { x.edge; }) {
      return x.edge < y;
    } else {
      return x < y.edge;
    }
  };
  const auto range = std::equal_range(edge_points.begin(), edge_points.end(), edge, less);
  return {range.first, range.second};
}

std::span<const PointInFacet> Network::points_in(std::uint32_t facet) const {
  const auto first = std::lower_bound(facet_points.begin(), facet_points.end(), facet,
                                      [](const PointInFacet& p, std::uint32_t f) { return p.facet < f; });
  auto last = first;
  while (last != facet_points.end() && last->facet == facet) ++last;
  return {first, last};
}

std::span<const Curve> Network::curves_in(std::uint32_t facet) const {
  const auto first = std::lower_bound(curves.begin(), curves.end(), facet,
                                      [](const Curve& c, std::uint32_t f) { return c.facet < f; });
  auto last = first;
  while (last != curves.end() && last->facet == facet) ++last;
  return {first, last};
}

Network make_network(Scene& scene, const Context& context) {
  return NetworkBuilder(scene, context).run();
}

}  // namespace quoin::overlay
