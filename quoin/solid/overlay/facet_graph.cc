// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/facet_graph.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace quoin::overlay {

void FacetGraph::build(std::uint32_t facet, std::size_t first_line) {
  facet_ = facet;
  first_line_ = first_line;
  axis_ = table_.main_axis(PlaneId{facet});
  orientation_ = table_.normal_component(PlaneId{facet}, axis_);
  curves_ = network_.curves_in(facet);
  first_curve_ = static_cast<std::uint32_t>(curves_.data() - network_.curves.data());
  signs_.assign(3 + curves_.size(), Sign::zero);
  raw_.clear();
  if (!network_.clusters.is_shared[facet]) add_boundary();
  add_curves();
  number_nodes();
  if (network_.clusters.is_shared[facet]) gather_units();
  drop_duplicates();
  link();
}

void FacetGraph::add_boundary() {
  const auto& corners = scene_.facets[facet_].corners;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const PointId from = corners[k];
    const PointId to = corners[(k + 1) % 3];
    chain_.assign(1, from);
    for (const PointOnEdge& p : network_.points_on(edge_between(from, to))) chain_.push_back(p.point);
    chain_.push_back(to);
    sort_chain();
    add_chain(k);
  }
}

void FacetGraph::add_curves() {
  auto crossing = std::lower_bound(crossings_.begin(), crossings_.end(), first_curve_,
                                   [](const PointOnCurve& p, std::uint32_t curve) { return p.curve < curve; });
  for (std::uint32_t i = 0; i < curves_.size(); ++i) {
    chain_.assign(1, curves_[i].from);
    for (; crossing != crossings_.end() && crossing->curve == first_curve_ + i; ++crossing) {
      if (crossing->point != curves_[i].from && crossing->point != curves_[i].to) chain_.push_back(crossing->point);
    }
    if (curves_[i].is_along_edge()) {
      for (const PointOnEdge& p : network_.points_on(curves_[i].edge)) chain_.push_back(p.point);
    }
    chain_.push_back(curves_[i].to);
    sort_chain();
    chain_.erase(std::unique(chain_.begin(), chain_.end()), chain_.end());
    add_chain(3 + i);
  }
}

// Orders the inner points of a chain from its first to its last point, along a coordinate in which these differ.
void FacetGraph::sort_chain() {
  if (chain_.size() < 4) return;
  const PointId from = chain_.front();
  const PointId to = chain_.back();
  unsigned axis = 0;
  for (unsigned k = 1; k < 3; ++k) {
    const auto length = [&](unsigned a) { return std::fabs(table_.rounded(to)[a] / 2 - table_.rounded(from)[a] / 2); };
    if (length(k) > length(axis)) axis = k;
  }
  Sign direction = table_.compare(to, from, axis);
  while (direction == Sign::zero) {
    axis = (axis + 1) % 3;
    direction = table_.compare(to, from, axis);
  }
  std::sort(chain_.begin() + 1, chain_.end() - 1,
            [&](PointId p, PointId q) { return table_.compare(q, p, axis) * direction == Sign::positive; });
}

void FacetGraph::add_chain(std::uint32_t line) {
  for (std::size_t i = 0; i + 1 < chain_.size(); ++i) raw_.push_back({chain_[i], chain_[i + 1], line});
}

// Pieces of one chain begin where the one before ends.
bool FacetGraph::follows(std::size_t piece) const {
  return piece > 0 && raw_[piece].from == raw_[piece - 1].to;
}

// In the order in which pieces name them, then those without pieces.
void FacetGraph::number_nodes() {
  nodes_.clear();
  const std::span<const PointInFacet> inside = network_.points_in(facet_);
  node_slots_.assign(std::bit_ceil(2 * (raw_.size() + inside.size()) + 2), no_node);
  pieces_.clear();
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < raw_.size(); ++i) {
    const std::uint32_t from = follows(i) ? last : number_of(raw_[i].from);
    last = number_of(raw_[i].to);
    pieces_.push_back({{from, last}, raw_[i].line});
  }
  for (const PointInFacet& p : inside) number_of(p.point);
  std::stable_sort(pieces_.begin(), pieces_.end(),
                   [&](const Piece& p, const Piece& q) { return ends_of(p) < ends_of(q); });
}

// Open addressing in a table at most half full: no graph has more nodes than pieces, points inside, and one.
std::uint32_t FacetGraph::number_of(PointId point) {
  const std::size_t mask = node_slots_.size() - 1;
  std::size_t slot = (point.value * 0x9E3779B1U >> 7U) & mask;
  while (node_slots_[slot] != no_node && nodes_[node_slots_[slot]] != point) slot = (slot + 1) & mask;
  if (node_slots_[slot] == no_node) {
    node_slots_[slot] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(point);
  }
  return node_slots_[slot];
}

// Overlapping curves leave the same piece several times; the one of the smallest line stays.
void FacetGraph::drop_duplicates() {
  pieces_.erase(std::unique(pieces_.begin(), pieces_.end(),
                            [&](const Piece& p, const Piece& q) { return ends_of(p) == ends_of(q); }),
                pieces_.end());
}

// A unit that occurs twice at a piece has it on both sides of its boundary.
void FacetGraph::gather_units() {
  first_unit_.assign(1, 0);
  units_.clear();
  for (std::size_t i = 0; i < pieces_.size();) {
    const auto begin = static_cast<std::ptrdiff_t>(units_.size());
    std::size_t j = i;
    for (; j < pieces_.size() && ends_of(pieces_[j]) == ends_of(pieces_[i]); ++j) add_units(pieces_[j].line);
    std::sort(units_.begin() + begin, units_.end());
    auto kept = units_.begin() + begin;
    for (auto unit = kept; unit != units_.end();) {
      const auto end = std::find_if(unit, units_.end(), [&](std::uint32_t u) { return u != *unit; });
      if ((end - unit) % 2 != 0) *kept++ = *unit;
      unit = end;
    }
    units_.erase(kept, units_.end());
    first_unit_.push_back(static_cast<std::uint32_t>(units_.size()));
    i = j;
  }
}

void FacetGraph::add_units(std::uint32_t line) {
  const Curve& curve = curves_[line - 3];
  if (!curve.is_along_edge()) return;
  for (const ClusterEdge& e : network_.clusters.edges_at(facet_, curve.edge)) units_.push_back(e.unit);
}

void FacetGraph::link() {
  first_leaving_.assign(nodes_.size() + 1, 0);
  const auto halfedges = static_cast<std::uint32_t>(2 * pieces_.size());
  for (std::uint32_t h = 0; h < halfedges; ++h) ++first_leaving_[tail(h) + 1];
  for (std::size_t n = 0; n < nodes_.size(); ++n) first_leaving_[n + 1] += first_leaving_[n];
  leaving_.resize(halfedges);
  std::vector<std::uint32_t> fill(first_leaving_.begin(), first_leaving_.end() - 1);
  for (std::uint32_t h = 0; h < halfedges; ++h) leaving_[fill[tail(h)]++] = h;
  next_.resize(halfedges);
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    sort_around(n);
    const std::span<const std::uint32_t> around = leaving(n);
    for (std::size_t i = 0; i < around.size(); ++i) {  // arriving against around[i], turn clockwise
      next_[around[i] ^ 1U] = around[i == 0 ? around.size() - 1 : i - 1];
    }
  }
}

// Counterclockwise; at a node of the boundary starting with the boundary itself.
void FacetGraph::sort_around(std::uint32_t node) {
  const std::span<std::uint32_t> around(leaving_.data() + first_leaving_[node],
                                        leaving_.data() + first_leaving_[node + 1]);
  if (around.size() <= 1) return;
  const auto is_boundary = [&](std::uint32_t h) { return pieces_[h / 2].line < 3; };
  const auto forward =
      std::find_if(around.begin(), around.end(), [&](std::uint32_t h) { return is_boundary(h) && (h & 1U) == 0; });
  if (forward == around.end()) {
    if (around.size() > 2) sort_full_turn(around);
    return;
  }
  std::iter_swap(around.begin(), forward);
  const auto backward = std::find_if(around.begin() + 1, around.end(), is_boundary);
  std::iter_swap(around.end() - 1, backward);
  std::sort(around.begin() + 1, around.end() - 1,
            [&](std::uint32_t g, std::uint32_t h) { return turn(g, h) == Sign::positive; });
}

void FacetGraph::sort_full_turn(std::span<std::uint32_t> halfedges) {
  const std::uint32_t reference = halfedges.front();
  // First the reference, then the half turn to its left, then the rest. Pieces in one direction would overlap.
  const auto half = [&](std::uint32_t h) {
    if (h == reference) return 0;
    return turn(reference, h) == Sign::positive ? 1 : turn(reference, h) == Sign::zero ? 2 : 3;
  };
  std::vector<std::pair<int, std::uint32_t>> keyed;
  for (const std::uint32_t h : halfedges) keyed.push_back({half(h), h});
  std::sort(keyed.begin(), keyed.end(), [&](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    return a.second != b.second && turn(a.second, b.second) == Sign::positive;
  });
  std::transform(keyed.begin(), keyed.end(), halfedges.begin(), [](const auto& k) { return k.second; });
}

LineId FacetGraph::line_id(std::uint32_t line) const {
  return LineId{line < 3 ? first_line_ + line : first_curve_ + line - 3};
}

// Sets the line when first asked for. Whether pieces run along its direction or against it.
Sign FacetGraph::direction_sign(std::uint32_t line) {
  Sign& sign = signs_[line];
  if (sign != Sign::zero) return sign;
  const LineId id = line_id(line);
  if (line < 3) {
    const auto& corners = scene_.facets[facet_].corners;
    table_.set_line(id, corners[line], corners[(line + 1) % 3]);
    return sign = Sign::positive;
  }
  const Curve& curve = curves_[line - 3];
  if (curve.is_along_edge()) {
    table_.set_line(id, PointId{curve.edge.a}, PointId{curve.edge.b});
  } else {
    table_.set_line(id, PlaneId{facet_}, curve.cut);
  }
  for (unsigned axis = 0; axis < 3 && sign == Sign::zero; ++axis) {
    const Sign component = table_.component(id, axis);
    if (component != Sign::zero) sign = component * table_.compare(curve.to, curve.from, axis);
  }
  return sign;
}

Sign FacetGraph::turn(std::uint32_t first, std::uint32_t second) {
  const std::uint32_t p = pieces_[first / 2].line;
  const std::uint32_t q = pieces_[second / 2].line;
  if (p == q) return Sign::zero;
  Sign result = direction_sign(p) * direction_sign(q) * orientation_;
  if (((first ^ second) & 1U) != 0) result = -result;
  return result * table_.turn(line_id(p), line_id(q), axis_);
}

bool FacetGraph::less(std::uint32_t m, std::uint32_t n) const {
  const Sign first = table_.compare(nodes_[m], nodes_[n], (axis_ + 1) % 3);
  if (first != Sign::zero) return first == Sign::negative;
  return table_.compare(nodes_[m], nodes_[n], (axis_ + 2) % 3) == Sign::negative;
}

// Positive when the point of the facet lies to the left of the line, directed as its pieces are.
Sign FacetGraph::left_of(std::uint32_t line, PointId point) {
  if (line < 3) {
    const auto& corners = scene_.facets[facet_].corners;
    return table_.turn_any(corners[line], corners[(line + 1) % 3], point, axis_) * orientation_;
  }
  // Left of n x m, for normals n of the facet and m of the cut, is where m points away: n x (n x m) . m < 0.
  const Curve& curve = curves_[line - 3];
  const Sign side = table_.side(point, curve.cut);
  return direction_sign(line) * (curve.is_along_edge() ? side * orientation_ : -side);
}

bool FacetGraph::ray_crosses(std::uint32_t n, std::uint32_t halfedge) {
  const unsigned first_axis = (axis_ + 1) % 3;
  const bool tail_after = table_.compare(nodes_[tail(halfedge)], nodes_[n], first_axis) == Sign::positive;
  const bool head_after = table_.compare(nodes_[head(halfedge)], nodes_[n], first_axis) == Sign::positive;
  if (tail_after == head_after) return false;
  Sign left = left_of(pieces_[halfedge / 2].line, nodes_[n]) * orientation_;
  if ((halfedge & 1U) != 0) left = -left;
  return left == (head_after ? Sign::negative : Sign::positive);
}

}  // namespace quoin::overlay
