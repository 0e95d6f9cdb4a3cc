// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "quoin/solid/overlay/crossings.h"

namespace quoin::overlay {

/// The planar graph of one facet, or of a cluster of facets: boundaries and curves, cut at all their vertices, and
/// vertices that touch from one side, as nodes without pieces.
///
/// Halfedges 2p and 2p + 1 are the two directions of piece p. `next` continues along the face on the left. Everything
/// "counterclockwise" and "left" is seen from the positive side of the facet's plane. One object serves many facets in
/// turn.
class FacetGraph {
 public:
  FacetGraph(Scene& scene, const Network& network, std::span<const PointOnCurve> crossings)
      : scene_(scene), table_(scene.table), network_(network), crossings_(crossings) {}

  /// Of a cluster, `facet` is the one that names it.
  ///
  /// Line slots first_line ... first_line + 2 of the table are for the facet's edges; those of its curves are the curve
  /// indices.
  void build(std::uint32_t facet, std::size_t first_line);

  std::size_t node_count() const { return nodes_.size(); }
  std::size_t piece_count() const { return pieces_.size(); }
  PointId node(std::uint32_t n) const { return nodes_[n]; }
  std::uint32_t tail(std::uint32_t halfedge) const { return pieces_[halfedge / 2].end[halfedge & 1U]; }
  std::uint32_t head(std::uint32_t halfedge) const { return pieces_[halfedge / 2].end[1U - (halfedge & 1U)]; }
  std::uint32_t next(std::uint32_t halfedge) const { return next_[halfedge]; }
  /// Runs along the facet's boundary with the facet on its right.
  bool is_outside(std::uint32_t halfedge) const { return (halfedge & 1U) != 0 && pieces_[halfedge / 2].line < 3; }

  /// The units of a cluster bounded by the piece, but for those it bounds on both sides.
  std::span<const std::uint32_t> units_at(std::uint32_t piece) const {
    return {units_.data() + first_unit_[piece], units_.data() + first_unit_[piece + 1]};
  }

  std::span<const std::uint32_t> leaving(std::uint32_t n) const {
    return {leaving_.data() + first_leaving_[n], leaving_.data() + first_leaving_[n + 1]};
  }

  /// Of halfedges that leave one node within less than half a turn, whether the second is counterclockwise of the
  /// first.
  Sign turn(std::uint32_t first, std::uint32_t second);
  /// Lexicographic order of two nodes in the projection of the facet.
  bool less(std::uint32_t m, std::uint32_t n) const;
  /// Whether the ray from the node towards the second projected coordinate crosses the halfedge (half-open rule); the
  /// node must not lie on it.
  bool ray_crosses(std::uint32_t n, std::uint32_t halfedge);

 private:
  // `line` 0 to 2: edge of the facet; 3 + i: curve i of the facet. Pieces run along the boundary, or from the curve's
  // `from` to its `to`.
  struct Piece {
    std::array<std::uint32_t, 2> end;
    std::uint32_t line;
  };
  static std::pair<std::uint32_t, std::uint32_t> ends_of(const Piece& p) {
    return {std::min(p.end[0], p.end[1]), std::max(p.end[0], p.end[1])};
  }

  void add_boundary();
  void add_curves();
  void add_chain(std::uint32_t line);
  void sort_chain();
  bool follows(std::size_t piece) const;
  void number_nodes();
  std::uint32_t number_of(PointId point);
  void drop_duplicates();
  void gather_units();
  void add_units(std::uint32_t line);
  void link();
  void sort_around(std::uint32_t node);
  void sort_full_turn(std::span<std::uint32_t> halfedges);
  Sign direction_sign(std::uint32_t line);
  LineId line_id(std::uint32_t line) const;
  Sign left_of(std::uint32_t line, PointId point);

  Scene& scene_;
  Constructions& table_;
  const Network& network_;
  std::span<const PointOnCurve> crossings_;

  std::uint32_t facet_ = 0;
  std::size_t first_line_ = 0;
  unsigned axis_ = 0;
  Sign orientation_ = Sign::zero;  // of the facet in the projection along axis_
  std::span<const Curve> curves_;
  std::uint32_t first_curve_ = 0;
  std::vector<PointId> chain_;
  struct RawPiece {
    PointId from;
    PointId to;
    std::uint32_t line;
  };
  std::vector<RawPiece> raw_;
  static constexpr std::uint32_t no_node = 0xFFFFFFFFU;
  std::vector<PointId> nodes_;
  std::vector<std::uint32_t> node_slots_;  // of a hash table: numbers of nodes
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> first_unit_;  // per piece; of clusters only
  std::vector<std::uint32_t> units_;
  std::vector<Sign> signs_;  // per line: zero while its direction is not set
  std::vector<std::uint32_t> first_leaving_;
  std::vector<std::uint32_t> leaving_;
  std::vector<std::uint32_t> next_;
};

}  // namespace quoin::overlay
