// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/overlay_sum.h"

#include <utility>

#include "quoin/base/disjoint_sets.h"
#include "quoin/polytope/map_overlay.h"

namespace quoin {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

/// The overlay of both maps as a graph on the sphere. Nodes are the facets of P, those of Q, and the crossings; each
/// arc between neighbouring nodes is two darts, 2a and 2a + 1. A dart has on its left the region where one vertex of
/// each polytope is extreme: a vertex of the sum.
class OverlayGraph {
 public:
  using Label = std::array<std::uint32_t, 2>;

  OverlayGraph(const PolytopeShape& p, const PolytopeShape& q, const Context& context)
      : p_(p), q_(q), predicates_(p, q), overlay_(p, q, predicates_, context), context_(context) {
    add_arcs_of_p();
    add_arcs_of_q();
    link_facets(p, p_darts_);
    link_facets(q, q_darts_);
    link_crossings();
  }

  PolytopeSum sum() {
    PolytopeSum result;
    result.dimension = 3;
    result.has_ties = predicates_.has_ties();
    DisjointSets classes(result.has_ties ? node_count() : 0);
    if (result.has_ties) contract(classes);
    trace_regions(result, classes);
    trace_facets(result);
    return result;
  }

 private:
  const std::vector<MapOverlay::Crossing>& crossings() const { return overlay_.crossings(); }
  std::size_t node_count() const { return p_.facet_count() + q_.facet_count() + crossings().size(); }
  std::uint32_t q_node(std::uint32_t facet) const { return static_cast<std::uint32_t>(p_.facet_count()) + facet; }
  std::uint32_t crossing_node(std::uint32_t crossing) const {
    return static_cast<std::uint32_t>(p_.facet_count() + q_.facet_count()) + crossing;
  }
  bool is_crossing(std::uint32_t node) const { return node >= crossing_node(0); }
  const MapOverlay::Crossing& crossing_at(std::uint32_t node) const { return crossings()[node - crossing_node(0)]; }
  std::uint32_t target(std::uint32_t dart) const { return origin_[dart ^ 1U]; }

  std::uint32_t add_arc(std::uint32_t from, std::uint32_t to, const Label& left, const Label& right) {
    const auto dart = static_cast<std::uint32_t>(origin_.size());
    if (dart % 512 == 0) context_.poll();
    origin_.push_back(from);
    origin_.push_back(to);
    left_.push_back(left);
    left_.push_back(right);
    return dart;
  }
  void add_arcs_of_p();
  void add_arcs_of_q();
  void link_ring(std::span<const std::uint32_t> ring);
  void link_facets(const PolytopeShape& polytope, std::span<const std::uint32_t> darts);
  void link_crossings();

  void contract(DisjointSets& classes) const;
  bool has_length(std::uint32_t dart) const;
  void join_back_tracking(std::vector<std::uint32_t>& region);
  void trace_regions(PolytopeSum& result, DisjointSets& classes);
  void trace_facets(PolytopeSum& result);

  const PolytopeShape& p_;
  const PolytopeShape& q_;
  MapPredicates predicates_;
  MapOverlay overlay_;
  const Context& context_;
  // By dart.
  std::vector<std::uint32_t> origin_;
  std::vector<Label> left_;
  std::vector<std::uint32_t> next_;      // around the region on the left
  std::vector<std::uint32_t> twin_;      // once arcs were joined
  std::vector<std::uint32_t> previous_;  // likewise; none of a dart that is gone
  std::vector<std::uint32_t> vertex_;
  // By halfedge that its arc runs along.
  std::vector<std::uint32_t> p_darts_;
  std::vector<std::uint32_t> q_darts_;
  std::uint32_t end_of_p_ = 0;  // darts of Q follow
  // By crossing: the dart that leaves it along the arc of P, and of Q.
  std::vector<std::uint32_t> out_on_p_;
  std::vector<std::uint32_t> out_on_q_;
};

void OverlayGraph::add_arcs_of_p() {
  p_darts_.assign(p_.halfedges().size(), none);
  out_on_p_.resize(crossings().size());
  for (std::uint32_t h = 0; h < p_.halfedges().size(); ++h) {
    if (!overlay_.is_walked(h)) continue;
    const PolytopeShape::Halfedge& arc = p_.halfedges()[h];
    std::uint32_t node = arc.facet;
    std::uint32_t region = overlay_.region_of_p_facet(arc.facet);
    for (std::uint32_t i = 0; i <= overlay_.count_on_p(h); ++i) {
      const std::uint32_t x = overlay_.begin_on_p(h) + i;
      const bool is_last = i == overlay_.count_on_p(h);
      const std::uint32_t to = is_last ? p_.halfedges()[arc.twin].facet : crossing_node(x);
      const std::uint32_t dart = add_arc(node, to, {arc.head, region}, {arc.tail, region});
      if (i == 0) p_darts_[h] = dart;
      if (i > 0) out_on_p_[x - 1] = dart;
      if (is_last) {
        p_darts_[arc.twin] = dart + 1;
      } else {
        region = q_.halfedges()[crossings()[x].q].head;
      }
      node = to;
    }
  }
  end_of_p_ = static_cast<std::uint32_t>(origin_.size());
}

void OverlayGraph::add_arcs_of_q() {
  q_darts_.assign(q_.halfedges().size(), none);
  out_on_q_.resize(crossings().size());
  for (std::uint32_t h = 0; h < q_.halfedges().size(); ++h) {
    if (!MapOverlay::is_forward(q_, h)) continue;
    const PolytopeShape::Halfedge& arc = q_.halfedges()[h];
    const auto chain = overlay_.on_q(h);
    std::uint32_t node = q_node(arc.facet);
    std::uint32_t region = overlay_.region_of_q_facet(arc.facet);
    for (std::size_t i = 0; i <= chain.size(); ++i) {
      const bool is_last = i == chain.size();
      const std::uint32_t to = is_last ? q_node(q_.halfedges()[arc.twin].facet) : crossing_node(chain[i]);
      const std::uint32_t dart = add_arc(node, to, {region, arc.head}, {region, arc.tail});
      if (i == 0) q_darts_[h] = dart;
      if (i > 0) out_on_q_[chain[i - 1]] = dart;
      if (is_last) {
        q_darts_[arc.twin] = dart + 1;
      } else {
        region = overlay_.region_behind(chain[i]);
      }
      node = to;
    }
  }
  next_.resize(origin_.size());
}

/// Darts that leave a node, counterclockwise: what arrives along one leaves along the one before.
void OverlayGraph::link_ring(std::span<const std::uint32_t> ring) {
  std::uint32_t before = ring.back();
  for (const std::uint32_t dart : ring) {
    next_[dart ^ 1U] = before;
    before = dart;
  }
}

void OverlayGraph::link_facets(const PolytopeShape& polytope, std::span<const std::uint32_t> darts) {
  std::vector<std::uint32_t> ring;
  for (std::uint32_t f = 0; f < polytope.facet_count(); ++f) {
    if (f % 512 == 0) context_.poll();
    ring.clear();
    std::uint32_t h = polytope.first_halfedge(f);
    do {
      ring.push_back(darts[h]);
      h = polytope.halfedges()[h].next;
    } while (h != polytope.first_halfedge(f));
    link_ring(ring);
  }
}

/// Counterclockwise: on along the halfedge of Q, on along that of P, back, back. What comes in on an arc of P is the
/// arc numbered just before; arcs of Q likewise.
void OverlayGraph::link_crossings() {
  for (std::uint32_t x = 0; x < crossings().size(); ++x) {
    if (x % 512 == 0) context_.poll();
    const std::uint32_t p_out = out_on_p_[x];
    const std::uint32_t p_back = p_out - 1;
    std::uint32_t q_out = out_on_q_[x];
    std::uint32_t q_back = q_out - 1;
    if (!MapOverlay::is_forward(q_, crossings()[x].q)) std::swap(q_out, q_back);
    link_ring(std::array{q_out, p_out, q_back, p_back});
  }
}

/// Whether the two ends of an arc are different directions. Not asked where edges that cross are parallel.
bool OverlayGraph::has_length(std::uint32_t dart) const {
  const std::uint32_t a = origin_[dart];
  const std::uint32_t b = target(dart);
  const bool on_p = dart < end_of_p_;
  if (!is_crossing(a) && !is_crossing(b)) return true;
  if (is_crossing(a) && is_crossing(b)) {
    const MapOverlay::Crossing& x = crossing_at(a);
    const MapOverlay::Crossing& y = crossing_at(b);
    const auto& p = p_.halfedges();
    const auto& q = q_.halfedges();
    const Sign sign = on_p ? determinant(p[x.p].vector, q[x.q].vector, q[y.q].vector,
                                         [&] { return exact_determinant(p_.edge(x.p), q_.edge(x.q), q_.edge(y.q)); })
                           : determinant(q[x.q].vector, p[x.p].vector, p[y.p].vector,
                                         [&] { return exact_determinant(q_.edge(x.q), p_.edge(x.p), p_.edge(y.p)); });
    return sign != Sign::zero;
  }
  const std::uint32_t facet = is_crossing(a) ? b : a;
  const MapOverlay::Crossing& x = crossing_at(is_crossing(a) ? a : b);
  const PolytopeShape& own = on_p ? p_ : q_;
  const PolytopeShape& other = on_p ? q_ : p_;
  const std::uint32_t f = on_p ? facet : facet - q_node(0);
  const std::uint32_t crossed = on_p ? x.q : x.p;
  const std::uint32_t h = own.first_halfedge(f);
  return side(own.normal(f), other.halfedges()[crossed].vector, [&] {
           return exact_determinant(own.edge(h), own.edge(own.halfedges()[h].next), other.edge(crossed));
         }) != Sign::zero;
}

/// Joins nodes of one direction: the ends of arcs without length, and a crossing of parallel edges, which lies inside
/// what their arcs have in common, with the node before it on the arc of P.
void OverlayGraph::contract(DisjointSets& classes) const {
  std::vector<bool> is_parallel(crossings().size());
  for (std::uint32_t x = 0; x < crossings().size(); ++x) {
    if (x % 256 == 0) context_.poll();
    is_parallel[x] = are_parallel(p_.edge(crossings()[x].p), q_.edge(crossings()[x].q));
    if (is_parallel[x]) classes.unite(crossing_node(x), origin_[out_on_p_[x] - 2]);
  }
  const auto is_of_parallels = [&](std::uint32_t node) {
    return is_crossing(node) && is_parallel[node - crossing_node(0)];
  };
  for (std::uint32_t dart = 0; dart < origin_.size(); dart += 2) {
    if (dart % 512 == 0) context_.poll();
    if (is_of_parallels(origin_[dart]) || is_of_parallels(target(dart)) || has_length(dart)) continue;
    classes.unite(origin_[dart], target(dart));
  }
}

/// Takes out neighbours that run from one class to another and back, and joins what lay behind them.
void OverlayGraph::join_back_tracking(std::vector<std::uint32_t>& region) {
  const auto is_back = [&](std::uint32_t a, std::uint32_t b) {
    return origin_[a] == origin_[twin_[b]] && origin_[twin_[a]] == origin_[b];
  };
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t behind_a = twin_[a];
    const std::uint32_t behind_b = twin_[b];
    twin_[behind_a] = behind_b;
    twin_[behind_b] = behind_a;
  };
  std::size_t kept = 0;
  for (const std::uint32_t dart : region) {
    if (kept > 0 && is_back(region[kept - 1], dart)) {
      join(region[--kept], dart);
    } else {
      region[kept++] = dart;
    }
  }
  std::size_t first = 0;
  while (kept > first + 1 && is_back(region[kept - 1], region[first])) join(region[--kept], region[first++]);
  region.resize(kept);
  region.erase(region.begin(), region.begin() + static_cast<std::ptrdiff_t>(first));
}

/// Regions of the overlay, without arcs whose ends are one: each that is left is a vertex.
void OverlayGraph::trace_regions(PolytopeSum& result, DisjointSets& classes) {
  const auto count = static_cast<std::uint32_t>(origin_.size());
  twin_.resize(count);
  for (std::uint32_t d = 0; d < count; ++d) twin_[d] = d ^ 1U;
  if (result.has_ties) {
    for (std::uint32_t& node : origin_) node = classes.find(node);
  }
  previous_.assign(count, none);
  vertex_.assign(count, none);
  std::vector<bool> is_done(count, false);
  std::vector<std::uint32_t> region;
  for (std::uint32_t first = 0; first < count; ++first) {
    if (first % 512 == 0) context_.poll();
    if (is_done[first]) continue;
    region.clear();
    std::uint32_t dart = first;
    do {
      is_done[dart] = true;
      if (origin_[dart] != origin_[dart ^ 1U]) region.push_back(dart);
      dart = next_[dart];
    } while (dart != first);
    if (result.has_ties) join_back_tracking(region);
    if (region.empty()) continue;
    const auto vertex = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.push_back(left_[first]);
    std::uint32_t before = region.back();
    for (const std::uint32_t d : region) {
      previous_[d] = before;
      vertex_[d] = vertex;
      before = d;
    }
  }
}

/// Around every class: the next dart counterclockwise is the twin of the one before this in its region.
void OverlayGraph::trace_facets(PolytopeSum& result) {
  std::vector<bool> is_done(origin_.size(), false);
  for (std::uint32_t first = 0; first < origin_.size(); ++first) {
    if (first % 512 == 0) context_.poll();
    if (is_done[first] || previous_[first] == none) continue;
    std::uint32_t dart = first;
    do {
      is_done[dart] = true;
      result.corners.push_back(vertex_[dart]);
      dart = twin_[previous_[dart]];
    } while (dart != first);
    result.facet_begin.push_back(result.corners.size());
  }
}

/// Both have the same vertices, edges and facets by number, and edges of one number are parallel: so are facets. Equal
/// and homothetic polytopes whose vertices come in one order are of this kind, and parallel boxes.
bool have_equal_maps(const PolytopeShape& p, const PolytopeShape& q, const Context& context) {
  if (p.dimension() != q.dimension() || p.halfedges().size() != q.halfedges().size()) return false;
  for (std::uint32_t h = 0; h < p.halfedges().size(); ++h) {
    if (h % 256 == 0) context.poll();
    const PolytopeShape::Halfedge& a = p.halfedges()[h];
    const PolytopeShape::Halfedge& b = q.halfedges()[h];
    if (a.tail != b.tail || a.head != b.head || a.twin != b.twin || a.facet != b.facet || a.next != b.next)
      return false;
    if (h < a.twin && !point_one_way(p.edge(h), q.edge(h))) return false;
  }
  return true;
}

PolytopeSum sum_of_equal_maps(const PolytopeShape& p, const Context& context) {
  PolytopeSum sum;
  sum.dimension = 3;
  sum.has_ties = true;
  for (std::uint32_t v = 0; v < p.vertex_count(); ++v) sum.vertices.push_back({v, v});
  for (std::uint32_t f = 0; f < p.facet_count(); ++f) {
    if (f % 512 == 0) context.poll();
    std::uint32_t h = p.first_halfedge(f);
    do {
      sum.corners.push_back(p.halfedges()[h].tail);
      h = p.halfedges()[h].next;
    } while (h != p.first_halfedge(f));
    sum.facet_begin.push_back(sum.corners.size());
  }
  return sum;
}

}  // namespace

PolytopeSum overlay_sum(const PolytopeShape& p, const PolytopeShape& q, const Context& context) {
  if (have_equal_maps(p, q, context)) return sum_of_equal_maps(p, context);
  return OverlayGraph(p, q, context).sum();
}

}  // namespace quoin
