// SPDX-License-Identifier: Apache-2.0
//
// Letters: s and t are the two facets, p and q the ends of their intersections with the plane of the other; "up" in s
// means towards the positive side of the plane of t. All intervals are directed along the vector product (normal of s)
// x (normal of t).
#include "quoin/solid/overlay/contacts.h"

#include <utility>

namespace quoin::overlay {

namespace {

enum class Feature : std::uint8_t { vertex, edge, interior };

// A place on a facet: vertex `index`, edge from corner `index` to the next, or the interior.
struct Place {
  Feature feature = Feature::interior;
  std::uint8_t index = 0;
};

using Signs = std::array<Sign, 3>;

// Where a facet meets the plane of the other: the ends of the interval, first to last.
struct Span {
  Place first;
  Place last;
  bool along_edge = false;  // two corners lie in the plane
  std::uint8_t edge = 0;    // that edge
};

constexpr std::size_t next(std::size_t k) {
  return k == 2 ? 0 : k + 1;
}
constexpr std::size_t previous(std::size_t k) {
  return k == 0 ? 2 : k - 1;
}

bool strictly_one_side(const Signs& signs) {
  return signs[0] != Sign::zero && signs[0] == signs[1] && signs[1] == signs[2];
}

bool all_zero(const Signs& signs) {
  return signs[0] == Sign::zero && signs[1] == Sign::zero && signs[2] == Sign::zero;
}

// Sides of the corners of `facet` with respect to the plane of `other`. A shared corner needs no arithmetic.
Signs sides(const Constructions& table, const Corners& facet, const Corners& other) {
  Signs result;
  for (std::size_t k = 0; k < 3; ++k) {
    const PointId p = facet[k];
    result[k] = is_corner(p, other) ? Sign::zero : table.orientation(other[0], other[1], other[2], p);
  }
  return result;
}

Place vertex(std::size_t k) {
  return {Feature::vertex, static_cast<std::uint8_t>(k)};
}
Place edge(std::size_t k) {
  return {Feature::edge, static_cast<std::uint8_t>(k)};
}

// An upward crossing of the boundary comes first, since the interior lies to its left.
Span span_of(const Signs& signs) {
  Span span;
  for (std::size_t k = 0; k < 3; ++k) {
    const Sign here = signs[k];
    const Sign after = signs[next(k)];
    const Sign before = signs[previous(k)];
    if (here == Sign::negative && after == Sign::positive) span.first = edge(k);
    if (here == Sign::positive && after == Sign::negative) span.last = edge(k);
    if (here != Sign::zero) continue;
    if (after == Sign::zero) {  // corners k and k+1 lie in the plane, `before` is the sign of the third
      span.along_edge = true;
      span.edge = static_cast<std::uint8_t>(k);
      span.first = vertex(before == Sign::positive ? next(k) : k);
      span.last = vertex(before == Sign::positive ? k : next(k));
      return span;
    }
    if (before == Sign::zero) continue;  // met with k - 1
    if (before != Sign::positive || after == Sign::positive) span.first = vertex(k);
    if (before != Sign::negative || after == Sign::negative) span.last = vertex(k);
  }
  return span;
}

using DirectedEdge = std::pair<PointId, PointId>;

// An edge of the facet that passes through the place from below to above.
DirectedEdge rising_edge(const Corners& facet, const Signs& signs, Place place) {
  const std::size_t i = place.index;
  if (place.feature == Feature::edge) {
    const DirectedEdge forward{facet[i], facet[next(i)]};
    return signs[i] == Sign::negative ? forward : DirectedEdge{forward.second, forward.first};
  }
  const std::size_t j = signs[next(i)] != Sign::zero ? next(i) : previous(i);
  if (signs[j] == Sign::positive) return {facet[i], facet[j]};
  return {facet[j], facet[i]};
}

class PairOfFacets {
 public:
  PairOfFacets(const Constructions& table, const Corners& s, const Corners& t, FacetPair pair, Contacts& out)
      : table_(table), pair_(pair), s_(s), t_(t), out_(out) {}

  // False when the facets lie in one plane.
  bool run() {
    signs_s_ = sides(table_, s_, t_);
    if (strictly_one_side(signs_s_)) return true;
    if (all_zero(signs_s_)) return false;
    signs_t_ = sides(table_, t_, s_);
    if (strictly_one_side(signs_t_)) return true;
    span_s_ = span_of(signs_s_);
    span_t_ = span_of(signs_t_);
    std::swap(span_t_.first, span_t_.last);  // t sees the common line in the other direction
    intersect();
    return true;
  }

 private:
  // Positive when place q of t comes after place p of s on the common line.
  Sign order(Place p, Place q) const {
    if (p.feature == Feature::vertex && q.feature == Feature::vertex && s_[p.index] == t_[q.index]) {
      return Sign::zero;
    }
    const DirectedEdge e = rising_edge(s_, signs_s_, p);
    const DirectedEdge f = rising_edge(t_, signs_t_, q);
    return table_.orientation(e.first, e.second, f.first, f.second);
  }

  static bool is_point(const Span& span) {
    return !span.along_edge && span.first.feature == Feature::vertex && span.last.feature == Feature::vertex &&
           span.first.index == span.last.index;
  }

  static Place between(const Span& span) { return span.along_edge ? edge(span.edge) : Place{}; }

  void intersect() {
    const Sign gap_after_s = order(span_s_.last, span_t_.first);
    if (gap_after_s == Sign::positive) return;
    const Sign gap_before_s = order(span_s_.first, span_t_.last);
    if (gap_before_s == Sign::negative) return;
    if (gap_after_s == Sign::zero) {
      meet(span_s_.last, span_t_.first);
      return;
    }
    if (gap_before_s == Sign::zero) {
      meet(span_s_.first, span_t_.last);
      return;
    }
    const Sign at_start = order(span_s_.first, span_t_.first);
    const PointRef start = meet(at_start == Sign::positive ? between(span_s_) : span_s_.first,
                                at_start == Sign::negative ? between(span_t_) : span_t_.first);
    if (is_point(span_s_) || is_point(span_t_)) return;
    const Sign at_end = order(span_s_.last, span_t_.last);
    const PointRef end = meet(at_end == Sign::negative ? between(span_s_) : span_s_.last,
                              at_end == Sign::positive ? between(span_t_) : span_t_.last);
    if (span_s_.along_edge || span_t_.along_edge) out_.adjoining.push_back(pair_);
    if (span_s_.along_edge) out_.met_edges.push_back(edge_along(s_, span_s_));
    if (span_t_.along_edge) out_.met_edges.push_back(edge_along(t_, span_t_));
    if (!span_s_.along_edge) out_.traces.push_back({pair_.a, start, end, pair_.b, edge_along(t_, span_t_)});
    if (!span_t_.along_edge) out_.traces.push_back({pair_.b, start, end, pair_.a, edge_along(s_, span_s_)});
  }

  static Edge edge_along(const Corners& facet, const Span& span) {
    return span.along_edge ? edge_between(facet[span.edge], facet[next(span.edge)]) : Edge{none, none};
  }

  static Edge edge_of(const Corners& facet, Place place) {
    return edge_between(facet[place.index], facet[next(place.index)]);
  }

  PointRef meet(Place in_s, Place in_t) {
    if (in_s.feature == Feature::vertex) return post_vertex(s_[in_s.index], t_, pair_.b, in_t);
    if (in_t.feature == Feature::vertex) return post_vertex(t_[in_t.index], s_, pair_.a, in_s);
    if (in_s.feature == Feature::edge && in_t.feature == Feature::edge) {
      return post_edges(edge_of(s_, in_s), edge_of(t_, in_t));
    }
    return in_s.feature == Feature::edge ? post_edge(edge_of(s_, in_s), pair_.b)
                                         : post_edge(edge_of(t_, in_t), pair_.a);
  }

  PointRef post_vertex(PointId v, const Corners& facet, std::uint32_t facet_index, Place place) {
    if (place.feature == Feature::edge) out_.edge_points.push_back({edge_of(facet, place), v});
    if (place.feature == Feature::interior) out_.facet_points.push_back({facet_index, v});
    return PointRef::point(v);
  }

  PointRef post_edge(Edge e, std::uint32_t facet_index) {
    const PointRef ref = PointRef::contact(out_.keys.size());
    out_.keys.push_back({e.a, e.b, facet_index, none});
    return ref;
  }

  PointRef post_edges(Edge e, Edge f) {
    if (f < e) std::swap(e, f);
    const PointRef ref = PointRef::contact(out_.keys.size());
    out_.keys.push_back({e.a, e.b, f.a, f.b});
    return ref;
  }

  const Constructions& table_;
  FacetPair pair_;
  const Corners& s_;
  const Corners& t_;
  Contacts& out_;
  Signs signs_s_{};
  Signs signs_t_{};
  Span span_s_;
  Span span_t_;
};

// Tiles of one leaf that are joined in an edge and lie in different planes have nothing but that edge in common.
bool are_neighbours(const Scene& scene, const Facet& s, const Facet& t) {
  if (s.leaf != t.leaf) return false;
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (scene.twin(s.tile, k, s.leaf).tile == t.tile) return true;
  }
  return false;
}

}  // namespace

void find_contacts(const Scene& scene, FacetPair pair, Contacts& out) {
  const Facet& s = scene.facets[pair.a];
  const Facet& t = scene.facets[pair.b];
  const std::size_t adjoining = out.adjoining.size();
  if (!PairOfFacets(scene.table, s.corners, t.corners, pair, out).run()) {
    find_coplanar_contacts(scene.table, s.corners, t.corners, pair, out);
  } else if (out.adjoining.size() > adjoining && are_neighbours(scene, s, t)) {
    out.adjoining.pop_back();
  }
}

bool are_separated(const Constructions& table, const Corners& a, const Corners& b) {
  const auto on_one_side = [&](const Corners& facet, const Corners& other) {
    Sign side = Sign::zero;
    for (const PointId p : facet) {
      if (is_corner(p, other)) continue;
      const Sign sign = table.orientation(other[0], other[1], other[2], p);
      if (sign == Sign::zero || sign == -side) return false;
      side = sign;
    }
    return side != Sign::zero;
  };
  return on_one_side(b, a) || on_one_side(a, b);
}

bool have_equal_corners(const Constructions& table, const Corners& a, const Corners& b) {
  for (const PointId p : a) {
    for (const PointId q : b) {
      if (p != q && table.rounded(p) == table.rounded(q) && table.equal(p, q)) return true;
    }
  }
  return false;
}

bool have_contacts(const Constructions& table, const Corners& a, const Corners& b) {
  Contacts contacts;
  if (!PairOfFacets(table, a, b, {0, 1}, contacts).run()) find_coplanar_contacts(table, a, b, {0, 1}, contacts);
  return !contacts.keys.empty() || !contacts.edge_points.empty() || !contacts.facet_points.empty() ||
         !contacts.traces.empty() || !contacts.overlapping.empty();
}

}  // namespace quoin::overlay
