// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/polygon_merge.h"

namespace quoin {

ConvexRing ConvexRing::of_facet(const PolytopeShape& shape, std::uint32_t facet) {
  ConvexRing ring;
  std::uint32_t h = shape.first_halfedge(facet);
  do {
    ring.vertices.push_back(shape.halfedges()[h].tail);
    ring.edges.push_back(shape.edge(h));
    h = shape.halfedges()[h].next;
  } while (h != shape.first_halfedge(facet));
  return ring;
}

ConvexRing ConvexRing::of_edge(const PolytopeShape& shape, std::uint32_t halfedge) {
  const PolytopeShape::Halfedge& h = shape.halfedges()[halfedge];
  return {{h.tail, h.head}, {shape.edge(halfedge), shape.edge(h.twin)}};
}

DirectionPlane::DirectionPlane(const EdgeVector& a, const EdgeVector& b) {
  for (axis_ = 0; axis_ < 3; ++axis_) {
    sign_ = cross_sign(a, b, axis_);
    if (sign_ != Sign::zero) return;
  }
}

bool DirectionPlane::is_in_first_half(const EdgeVector& v) const {
  const Sign second = sign_ * component_sign(v, (axis_ + 2) % 3);
  return second == Sign::positive || (second == Sign::zero && component_sign(v, (axis_ + 1) % 3) == Sign::positive);
}

namespace {

/// A ring from the vertex where the first half of directions begins.
class Walk {
 public:
  Walk(const ConvexRing& ring, const DirectionPlane& plane) : ring_(ring), plane_(plane) {
    const std::size_t n = ring.edges.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (plane.is_in_first_half(ring.edges[i]) && !plane.is_in_first_half(ring.edges[(i + n - 1) % n])) at_ = i;
    }
  }
  std::uint32_t vertex() const { return ring_.vertices[at_]; }
  bool is_done() const { return walked_ == ring_.edges.size(); }
  const EdgeVector& edge() const { return ring_.edges[at_]; }
  void step() {
    at_ = (at_ + 1) % ring_.edges.size();
    ++walked_;
  }
  /// Positive: the next edge of this one comes first.
  Sign precedence(const Walk& other) const {
    if (is_done() || other.is_done()) return is_done() ? Sign::negative : Sign::positive;
    const bool is_first = plane_.is_in_first_half(edge());
    if (is_first != plane_.is_in_first_half(other.edge())) return is_first ? Sign::positive : Sign::negative;
    return plane_.turn(edge(), other.edge());
  }

 private:
  const ConvexRing& ring_;
  const DirectionPlane& plane_;
  std::size_t at_ = 0;
  std::size_t walked_ = 0;
};

}  // namespace

std::vector<std::array<std::uint32_t, 2>> merge_rings(const ConvexRing& p, const ConvexRing& q,
                                                      const DirectionPlane& plane) {
  Walk a(p, plane);
  Walk b(q, plane);
  std::vector<std::array<std::uint32_t, 2>> sum;
  while (!a.is_done() || !b.is_done()) {
    sum.push_back({a.vertex(), b.vertex()});
    const Sign sign = a.precedence(b);
    if (sign != Sign::negative) a.step();
    if (sign != Sign::positive) b.step();
  }
  return sum;
}

}  // namespace quoin
