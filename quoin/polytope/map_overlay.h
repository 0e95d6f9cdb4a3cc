// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/polytope/map_predicates.h"
#include "quoin/polytope/polytope_shape.h"

namespace quoin {

/// Where the arcs of two Gaussian maps cross, and which region of one map holds each point of the other.
///
/// Arcs of P are walked from facet to facet through the regions of Q: the exit of a region is the edge whose plane the
/// arc passes first. What is crossed on an arc of Q is put in order by the regions of P that it leads from and to,
/// without any predicate. O(crossings + sizes), with the degrees of Q's vertices in the first term.
class MapOverlay {
 public:
  struct Crossing {
    std::uint32_t p;  ///< halfedge of P: the arc runs from its facet to its twin's
    std::uint32_t q;  ///< halfedge of Q, from the region that the arc leaves to the one that it enters
  };

  MapOverlay(const PolytopeShape& p, const PolytopeShape& q, MapPredicates& predicates, const Context& context);

  const std::vector<Crossing>& crossings() const { return crossings_; }

  /// An arc of P was walked in one direction: along this halfedge, not its twin.
  bool is_walked(std::uint32_t halfedge_of_p) const { return begin_on_p_[halfedge_of_p] != not_walked; }
  /// Along a walked halfedge of P: its crossings are consecutive.
  std::uint32_t begin_on_p(std::uint32_t halfedge) const { return begin_on_p_[halfedge]; }
  std::uint32_t count_on_p(std::uint32_t halfedge) const { return count_on_p_[halfedge]; }
  /// Arcs of Q run along the smaller of their two halfedges. Numbers of crossings, in order along it.
  static bool is_forward(const PolytopeShape& polytope, std::uint32_t halfedge) {
    return halfedge < polytope.halfedges()[halfedge].twin;
  }
  std::span<const std::uint32_t> on_q(std::uint32_t halfedge) const {
    return {on_q_.data() + begin_on_q_[halfedge], begin_on_q_[halfedge + 1] - begin_on_q_[halfedge]};
  }
  /// Where an arc of Q leads to at a crossing, along its smaller halfedge.
  std::uint32_t region_behind(std::uint32_t crossing) const { return regions_of(crossing).second; }

  std::uint32_t region_of_p_facet(std::uint32_t facet) const { return region_of_p_facet_[facet]; }  ///< a vertex of Q
  std::uint32_t region_of_q_facet(std::uint32_t facet) const { return region_of_q_facet_[facet]; }  ///< a vertex of P

 private:
  static constexpr std::uint32_t not_walked = 0xFFFFFFFFU;
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  /// Before each predicate: one facet may take as many as its edges times the degree of a vertex.
  void count_predicate() {
    if (++predicate_count_ % 256 == 0) context_.poll();
  }
  std::uint32_t first_region();
  void walk_all();
  std::uint32_t walk(std::uint32_t halfedge, std::uint32_t region);
  std::pair<std::uint32_t, std::uint32_t> regions_of(std::uint32_t crossing) const;
  void order_on_q();
  void order_chain(std::span<std::uint32_t> chain);
  void find_regions_of_q_facets();

  const PolytopeShape& p_;
  const PolytopeShape& q_;
  MapPredicates& predicates_;
  const Context& context_;
  std::size_t predicate_count_ = 0;
  std::vector<Crossing> crossings_;
  std::vector<std::uint32_t> begin_on_p_;
  std::vector<std::uint32_t> count_on_p_;
  std::vector<std::uint32_t> begin_on_q_;
  std::vector<std::uint32_t> on_q_;
  std::vector<std::uint32_t> region_of_p_facet_;
  std::vector<std::uint32_t> region_of_q_facet_;
  std::vector<std::uint32_t> from_region_;  // scratch, by vertex of P: the crossing that leads from it, or none
  std::vector<bool> is_led_to_;             // scratch, by vertex of P
  std::vector<std::uint32_t> chain_;        // scratch
};

}  // namespace quoin
