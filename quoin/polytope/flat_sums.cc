// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/flat_sums.h"

#include <algorithm>
#include <utility>

#include "quoin/polytope/polygon_merge.h"

namespace quoin {

namespace {

using Label = std::array<std::uint32_t, 2>;

/// Collects facets by the labels of their corners, then numbers these.
class FacetCollector {
 public:
  void add(std::span<const Label> facet) {
    corners_.insert(corners_.end(), facet.begin(), facet.end());
    sum_.facet_begin.push_back(corners_.size());
  }
  PolytopeSum take(int dimension, bool has_ties) {
    sum_.dimension = dimension;
    sum_.has_ties = has_ties;
    sum_.vertices = corners_;
    std::sort(sum_.vertices.begin(), sum_.vertices.end());
    sum_.vertices.erase(std::unique(sum_.vertices.begin(), sum_.vertices.end()), sum_.vertices.end());
    for (const Label& label : corners_) {
      const auto place = std::lower_bound(sum_.vertices.begin(), sum_.vertices.end(), label);
      sum_.corners.push_back(static_cast<std::uint32_t>(place - sum_.vertices.begin()));
    }
    return std::move(sum_);
  }

 private:
  PolytopeSum sum_;
  std::vector<Label> corners_;
};

/// Of a facet's outward normal and a halfedge of another polytope.
Sign side_of_normal(const PolytopeShape& p, std::uint32_t facet, const PolytopeShape& q, std::uint32_t halfedge) {
  return side(p.normal(facet), q.halfedges()[halfedge].vector, [&] {
    const std::uint32_t h = p.first_halfedge(facet);
    return exact_determinant(p.edge(h), p.edge(p.halfedges()[h].next), q.edge(halfedge));
  });
}

DirectionPlane plane_of(const PolytopeShape& p, std::uint32_t facet) {
  const std::uint32_t h = p.first_halfedge(facet);
  return {p.edge(h), p.edge(p.halfedges()[h].next)};
}

PolytopeSum swapped(PolytopeSum sum) {
  for (auto& [a, b] : sum.vertices) std::swap(a, b);
  return sum;
}

/// The facet of a polygon that faces up, as that of a flat sum does.
std::uint32_t upper_facet(const PolytopeShape& p) {
  return plane_of(p, 0).faces_up() ? 0 : 1;
}

PolytopeSum sum_with_point(const PolytopeShape& p) {
  PolytopeSum sum;
  sum.dimension = p.dimension();
  for (std::uint32_t v = 0; v < p.vertex_count(); ++v) sum.vertices.push_back({v, 0});
  const auto add_facet = [&](std::uint32_t f) {
    const std::vector<std::uint32_t> ring = ConvexRing::of_facet(p, f).vertices;
    sum.corners.insert(sum.corners.end(), ring.begin(), ring.end());
    sum.facet_begin.push_back(sum.corners.size());
  };
  if (p.dimension() == 2) add_facet(upper_facet(p));
  for (std::uint32_t f = 0; p.dimension() == 3 && f < p.facet_count(); ++f) add_facet(f);
  return sum;
}

PolytopeSum sum_of_parallel_segments(const PolytopeShape& p, const PolytopeShape& q) {
  PolytopeSum sum;
  sum.dimension = 1;
  sum.has_ties = true;
  const std::uint32_t first = point_one_way(p.edge(0), q.edge(0)) ? 0 : 1;
  sum.vertices = {{0, first}, {1, 1 - first}};
  return sum;
}

/// Both in parallel planes, the rings counterclockwise in them.
PolytopeSum planar_sum(const ConvexRing& p, const ConvexRing& q, const DirectionPlane& plane) {
  const std::vector<Label> facet = merge_rings(p, q, plane);
  FacetCollector collector;
  collector.add(facet);
  return collector.take(2, facet.size() < p.edges.size() + q.edges.size());
}

PolytopeSum sum_of_segments(const PolytopeShape& p, const PolytopeShape& q) {
  if (are_parallel(p.edge(0), q.edge(0))) return sum_of_parallel_segments(p, q);
  DirectionPlane plane(p.edge(0), q.edge(0));
  if (!plane.faces_up()) plane = DirectionPlane(q.edge(0), p.edge(0));
  return planar_sum(ConvexRing::of_edge(p, 0), ConvexRing::of_edge(q, 0), plane);
}

/// By facet: whether it looks along the segment, against it or past it.
std::vector<Sign> looks(const PolytopeShape& solid, const PolytopeShape& segment, const Context& context) {
  std::vector<Sign> result;
  for (std::uint32_t f = 0; f < solid.facet_count(); ++f) {
    if (f % 1024 == 0) context.poll();
    result.push_back(side_of_normal(solid, f, segment, 0));
  }
  return result;
}

PolytopeSum sum_with_segment(const PolytopeShape& solid, const PolytopeShape& segment, const Context& context) {
  const std::vector<Sign> look = looks(solid, segment, context);
  const ConvexRing both_ways = ConvexRing::of_edge(segment, 0);
  FacetCollector collector;
  for (std::uint32_t f = 0; f < solid.facet_count(); ++f) {
    if (f % 1024 == 0) context.poll();
    const ConvexRing ring = ConvexRing::of_facet(solid, f);
    const ConvexRing end = ConvexRing::of_vertex(look[f] == Sign::positive ? 1 : 0);
    if (look[f] == Sign::zero) {
      collector.add(merge_rings(ring, both_ways, plane_of(solid, f)));
      continue;
    }
    std::vector<Label> facet;
    for (const std::uint32_t v : ring.vertices) facet.push_back({v, end.vertices[0]});
    collector.add(facet);
  }
  for (const PolytopeShape::Halfedge& h : solid.halfedges()) {
    const std::uint32_t across = solid.halfedges()[h.twin].facet;
    if (look[h.facet] != Sign::positive || look[across] != Sign::negative) continue;
    collector.add(std::array<Label, 4>{{{h.head, 1}, {h.tail, 1}, {h.tail, 0}, {h.head, 0}}});
  }
  return collector.take(3, std::find(look.begin(), look.end(), Sign::zero) != look.end());
}

/// A polygon and a polygon or segment that leaves its plane.
class SumAcrossPlane {
 public:
  SumAcrossPlane(const PolytopeShape& p, const PolytopeShape& q, const Context& context)
      : p_(p), q_(q), context_(context) {}

  PolytopeSum sum() {
    for (std::uint32_t f = 0; f < 2; ++f) add_own_facet(p_, f, q_, false);
    for (std::uint32_t f = 0; q_.dimension() == 2 && f < 2; ++f) add_own_facet(q_, f, p_, true);
    add_parallelograms();
    return collector_.take(3, has_ties_);
  }

 private:
  /// Halfedges around a polygon, or one along a segment.
  static std::vector<std::uint32_t> directions(const PolytopeShape& shape) {
    std::vector<std::uint32_t> result;
    const std::uint32_t first = shape.dimension() == 2 ? shape.first_halfedge(0) : 0;
    std::uint32_t h = first;
    do {
      result.push_back(h);
      h = shape.halfedges()[h].next;
    } while (h != first && shape.dimension() == 2);
    return result;
  }
  void add_own_facet(const PolytopeShape& own, std::uint32_t facet, const PolytopeShape& other, bool is_swapped);
  void add_parallelograms();

  const PolytopeShape& p_;
  const PolytopeShape& q_;
  const Context& context_;
  FacetCollector collector_;
  bool has_ties_ = false;
};

/// With what of the other is furthest along its normal: a vertex, or an edge parallel to its plane.
void SumAcrossPlane::add_own_facet(const PolytopeShape& own, std::uint32_t facet, const PolytopeShape& other,
                                   bool is_swapped) {
  const std::uint32_t start = other.dimension() == 2 ? other.first_halfedge(0) : 0;
  std::uint32_t h = start;
  // Up to the last edge that climbs.
  while (side_of_normal(own, facet, other, h) != Sign::positive) h = other.halfedges()[h].next;
  while (side_of_normal(own, facet, other, h) == Sign::positive) h = other.halfedges()[h].next;
  const bool is_parallel = side_of_normal(own, facet, other, h) == Sign::zero;
  has_ties_ = has_ties_ || is_parallel;
  const ConvexRing furthest =
      is_parallel ? ConvexRing::of_edge(other, h) : ConvexRing::of_vertex(other.halfedges()[h].tail);
  std::vector<Label> sum = merge_rings(ConvexRing::of_facet(own, facet), furthest, plane_of(own, facet));
  for (auto& [a, b] : sum) {
    if (is_swapped) std::swap(a, b);
  }
  collector_.add(sum);
}

void SumAcrossPlane::add_parallelograms() {
  const std::vector<std::uint32_t> of_p = directions(p_);
  const std::vector<std::uint32_t> of_q = directions(q_);
  std::vector<Sign> climbs_p;  // by direction of Q, along P's normal
  for (const std::uint32_t h : of_q) climbs_p.push_back(side_of_normal(p_, 0, q_, h));
  for (const std::uint32_t e : of_p) {
    context_.poll();
    // A segment has an edge of either direction, and one will do.
    const Sign climb = q_.dimension() == 2 ? side_of_normal(q_, 0, p_, e) : -climbs_p[0];
    for (std::size_t k = 0; k < of_q.size(); ++k) {
      if (climb == Sign::zero || climbs_p[k] != -climb) continue;
      const PolytopeShape::Halfedge& a = p_.halfedges()[e];
      const PolytopeShape::Halfedge& b = q_.halfedges()[of_q[k]];
      std::array<Label, 4> facet{{{a.tail, b.tail}, {a.head, b.tail}, {a.head, b.head}, {a.tail, b.head}}};
      if (climbs_p[k] == Sign::negative) std::swap(facet[1], facet[3]);
      collector_.add(facet);
    }
  }
}

/// Neither is a point, the first not of lower dimension than the second.
PolytopeSum sum_of_flat(const PolytopeShape& p, const PolytopeShape& q, const Context& context) {
  if (p.dimension() == 1) return sum_of_segments(p, q);
  const std::uint32_t upper = upper_facet(p);
  if (q.dimension() == 1) {
    if (side_of_normal(p, 0, q, 0) != Sign::zero) return SumAcrossPlane(p, q, context).sum();
    return planar_sum(ConvexRing::of_facet(p, upper), ConvexRing::of_edge(q, 0), plane_of(p, upper));
  }
  const std::uint32_t h = q.first_halfedge(0);
  if (side_of_normal(p, 0, q, h) != Sign::zero || side_of_normal(p, 0, q, q.halfedges()[h].next) != Sign::zero) {
    return SumAcrossPlane(p, q, context).sum();
  }
  return planar_sum(ConvexRing::of_facet(p, upper), ConvexRing::of_facet(q, upper_facet(q)), plane_of(p, upper));
}

}  // namespace

PolytopeSum flat_sum(const PolytopeShape& p, const PolytopeShape& q, const Context& context) {
  context.poll();
  if (p.dimension() < q.dimension()) return swapped(flat_sum(q, p, context));
  if (q.dimension() == 0) return sum_with_point(p);
  if (p.dimension() == 3) return sum_with_segment(p, q, context);
  return sum_of_flat(p, q, context);
}

}  // namespace quoin
