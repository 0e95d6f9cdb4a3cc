// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/map_overlay.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "quoin/base/error.h"

namespace quoin {

MapOverlay::MapOverlay(const PolytopeShape& p, const PolytopeShape& q, MapPredicates& predicates,
                       const Context& context)
    : p_(p),
      q_(q),
      predicates_(predicates),
      context_(context),
      begin_on_p_(p.halfedges().size(), not_walked),
      count_on_p_(p.halfedges().size(), 0),
      region_of_p_facet_(p.facet_count(), none),
      region_of_q_facet_(q.facet_count(), none),
      from_region_(p.vertex_count(), none),
      is_led_to_(p.vertex_count(), false) {
  walk_all();
  order_on_q();
  find_regions_of_q_facets();
}

/// That of the first facet of P, by climbing.
std::uint32_t MapOverlay::first_region() {
  std::uint32_t region = 0;
  for (std::uint32_t k = q_.first_out(region); k < q_.end_out(region);) {
    count_predicate();
    if (predicates_.side_of_normal(0, k) == Sign::positive) {
      region = q_.halfedges()[k].head;
      k = q_.first_out(region);
    } else {
      ++k;
    }
  }
  return region;
}

/// Breadth first, so that the regions in hand stay near.
void MapOverlay::walk_all() {
  std::vector<std::uint32_t> queue{0};
  region_of_p_facet_[0] = first_region();
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (i % 64 == 0) context_.poll();
    const std::uint32_t facet = queue[i];
    const std::uint32_t first = p_.first_halfedge(facet);
    std::uint32_t h = first;
    do {
      const PolytopeShape::Halfedge& halfedge = p_.halfedges()[h];
      if (!is_walked(halfedge.twin)) {
        const std::uint32_t target = p_.halfedges()[halfedge.twin].facet;
        const std::uint32_t region = walk(h, region_of_p_facet_[facet]);
        std::uint32_t& known = region_of_p_facet_[target];
        if (known == none) {
          known = region;
          queue.push_back(target);
        } else if (known != region) {
          throw InternalError("Minkowski sum: two ways to facet " + std::to_string(target) +
                              " end in different regions");
        }
      }
      h = halfedge.next;
    } while (h != first);
  }
}

/// Crosses edges of Q as long as the end of the arc is beyond one of the region's. The region where it ends.
std::uint32_t MapOverlay::walk(std::uint32_t halfedge, std::uint32_t region) {
  const std::uint32_t target = p_.halfedges()[p_.halfedges()[halfedge].twin].facet;
  begin_on_p_[halfedge] = static_cast<std::uint32_t>(crossings_.size());
  std::uint32_t back = none;
  for (;;) {
    std::uint32_t best = none;
    for (std::uint32_t k = q_.first_out(region); k < q_.end_out(region); ++k) {
      if (k == back) continue;
      count_predicate();
      if (predicates_.side_of_normal(target, k) != Sign::positive) continue;
      if (best == none || predicates_.order_along_arc(halfedge, k, best) == Sign::positive) best = k;
    }
    if (best == none) break;
    crossings_.push_back({halfedge, best});
    region = q_.halfedges()[best].head;
    back = q_.halfedges()[best].twin;
  }
  count_on_p_[halfedge] = static_cast<std::uint32_t>(crossings_.size()) - begin_on_p_[halfedge];
  return region;
}

/// Of P, before and behind a crossing along the forward direction of the arc of Q. Along its halfedge q the arc leads
/// from the region on the left of the arc of P to that on its right.
std::pair<std::uint32_t, std::uint32_t> MapOverlay::regions_of(std::uint32_t crossing) const {
  const PolytopeShape::Halfedge& arc = p_.halfedges()[crossings_[crossing].p];
  if (is_forward(q_, crossings_[crossing].q)) return {arc.head, arc.tail};
  return {arc.tail, arc.head};
}

void MapOverlay::order_on_q() {
  const auto forward = [&](std::uint32_t q) { return std::min(q, q_.halfedges()[q].twin); };
  begin_on_q_.assign(q_.halfedges().size() + 1, 0);
  for (std::uint32_t x = 0; x < crossings_.size(); ++x) {
    if (x % 4096 == 0) context_.poll();
    ++begin_on_q_[forward(crossings_[x].q) + 1];
  }
  std::partial_sum(begin_on_q_.begin(), begin_on_q_.end(), begin_on_q_.begin());
  on_q_.resize(crossings_.size());
  std::vector<std::uint32_t> end(begin_on_q_);
  for (std::uint32_t x = 0; x < crossings_.size(); ++x) {
    if (x % 4096 == 0) context_.poll();
    on_q_[end[forward(crossings_[x].q)]++] = x;
  }
  for (std::size_t q = 0; q + 1 < begin_on_q_.size(); ++q) {
    if (q % 512 == 0) context_.poll();
    const std::uint32_t count = begin_on_q_[q + 1] - begin_on_q_[q];
    if (count > 1) order_chain({on_q_.data() + begin_on_q_[q], count});
  }
}

/// Each begins where the one before leads to; the first begins where none leads to.
void MapOverlay::order_chain(std::span<std::uint32_t> chain) {
  for (const std::uint32_t x : chain) {
    from_region_[regions_of(x).first] = x;
    is_led_to_[regions_of(x).second] = true;
  }
  std::uint32_t next = none;
  for (const std::uint32_t x : chain) {
    if (!is_led_to_[regions_of(x).first]) next = x;
  }
  chain_.clear();
  while (next != none && chain_.size() < chain.size()) {
    chain_.push_back(next);
    next = from_region_[regions_of(next).second];
  }
  for (const std::uint32_t x : chain) {
    from_region_[regions_of(x).first] = none;
    is_led_to_[regions_of(x).second] = false;
  }
  if (chain_.size() != chain.size()) throw InternalError("Minkowski sum: the crossings of an arc are no chain");
  std::copy(chain_.begin(), chain_.end(), chain.begin());
}

/// From the crossings of an arc of the facet, else from a neighbour across an arc without any.
void MapOverlay::find_regions_of_q_facets() {
  std::vector<std::uint32_t> waiting;
  std::size_t found = 0;
  const auto set = [&](std::uint32_t facet, std::uint32_t region) {
    std::uint32_t& known = region_of_q_facet_[facet];
    if (known != none) return;
    known = region;
    waiting.push_back(facet);
    ++found;
  };
  const auto halfedges = q_.halfedges();
  for (std::uint32_t q = 0; q < halfedges.size(); ++q) {
    if (q % 512 == 0) context_.poll();
    const auto chain = on_q(q);
    if (chain.empty()) continue;
    set(halfedges[q].facet, regions_of(chain.front()).first);
    set(halfedges[halfedges[q].twin].facet, regions_of(chain.back()).second);
  }
  for (std::size_t taken = 0; !waiting.empty(); ++taken) {
    if (taken % 512 == 0) context_.poll();
    const std::uint32_t facet = waiting.back();
    waiting.pop_back();
    const std::uint32_t first = q_.first_halfedge(facet);
    std::uint32_t h = first;
    do {
      const std::uint32_t forward = std::min(h, halfedges[h].twin);
      if (on_q(forward).empty()) set(halfedges[halfedges[h].twin].facet, region_of_q_facet_[facet]);
      h = halfedges[h].next;
    } while (h != first);
  }
  if (found != q_.facet_count()) throw InternalError("Minkowski sum: a facet lies in no region");
}

}  // namespace quoin
