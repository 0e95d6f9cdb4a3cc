// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "quoin/solid/overlay/scene.h"

namespace quoin::overlay {

/// An undirected edge of facets by its end points, a < b. Coincident edges of several leaves are one.
struct Edge {
  std::uint32_t a;
  std::uint32_t b;
  friend auto operator<=>(const Edge&, const Edge&) = default;
};

inline Edge edge_between(PointId p, PointId q) {
  return p.value < q.value ? Edge{p.value, q.value} : Edge{q.value, p.value};
}

/// Where the interior of an edge crosses the interior of a facet (c = facet, d = none) or of another edge (c, d).
struct ContactKey {
  std::uint32_t a;
  std::uint32_t b;
  std::uint32_t c;
  std::uint32_t d;
  friend auto operator<=>(const ContactKey&, const ContactKey&) = default;
};

/// A vertex of the overlay before contacts have ids: an explicit point, or a contact by its place in a list.
struct PointRef {
  std::uint32_t value = none;
  static constexpr std::uint32_t contact_bit = 0x80000000U;

  static PointRef point(PointId p) { return {p.value}; }
  static PointRef contact(std::size_t index) { return {static_cast<std::uint32_t>(index) | contact_bit}; }
  bool is_contact() const { return (value & contact_bit) != 0; }
  std::size_t contact_index() const { return value & ~contact_bit; }
  friend bool operator==(PointRef, PointRef) = default;
};

/// A vertex strictly inside an edge.
struct PointOnEdge {
  Edge edge;
  PointId point;
  friend auto operator<=>(const PointOnEdge&, const PointOnEdge&) = default;
};

/// A vertex strictly inside a facet, or inside a unit of the cluster that the facet names.
struct PointInFacet {
  std::uint32_t facet;
  PointId point;
  friend auto operator<=>(const PointInFacet&, const PointInFacet&) = default;
};

/// What another facet, not of its plane, leaves on a facet.
struct Trace {
  std::uint32_t facet;
  PointRef from;
  PointRef to;
  std::uint32_t cutter;  ///< facet whose plane cuts
  Edge edge;             ///< the cutter's edge along which the trace runs, or {none, none}
};

/// Everything that pairs of facets have in common.
struct Contacts {
  std::vector<ContactKey> keys;  ///< say what each contact lies on; one found by several pairs occurs several times
  std::vector<PointOnEdge> edge_points;    ///< of corners
  std::vector<PointInFacet> facet_points;  ///< of corners
  std::vector<Trace> traces;
  std::vector<FacetPair>
      adjoining;  ///< pairs that share area, or a segment along an edge of one, and are not plain neighbours
  std::vector<Edge> met_edges;         ///< edges of facets along which a facet of another plane runs
  std::vector<FacetPair> overlapping;  ///< pairs in one plane that share area
};

/// Appends what facets a and b have in common.
///
/// Exact, from signs of explicit points alone: at most 10 orientations, or 18 plane turns where the facets are
/// coplanar. Each contact is named by the pair of features (vertex, edge, facet) that meet in it, so that the two
/// facets at an edge report the same contact under the same name.
/// Source: Guigue and Devillers 2003 for the order of the two intervals on the common line.
void find_contacts(const Scene& scene, FacetPair pair, Contacts& out);

/// Whether the corners of one triangle that are no corners of the other lie strictly on one side of the other's plane:
/// then the two meet in nothing but the vertices (by id) and edges that they share.
bool are_separated(const Constructions& points, const Corners& a, const Corners& b);

inline bool is_corner(PointId p, const Corners& of) {
  return p == of[0] || p == of[1] || p == of[2];
}

inline bool have_same_corners(const Corners& a, const Corners& b) {
  return is_corner(a[0], b) && is_corner(a[1], b) && is_corner(a[2], b);
}

/// Whether a corner of one triangle and a corner of the other, different ids, are the same explicit point.
bool have_equal_corners(const Constructions& points, const Corners& a, const Corners& b);

/// Whether two triangles over explicit points, neither of zero area, meet outside the vertices (by id) and edges that
/// they share.
bool have_contacts(const Constructions& points, const Corners& a, const Corners& b);

/// What two facets in one plane have in common.
void find_coplanar_contacts(const Constructions& points, const Corners& a, const Corners& b, FacetPair pair,
                            Contacts& out);

}  // namespace quoin::overlay
