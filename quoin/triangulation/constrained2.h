// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/triangulation/segment_pieces2.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin {

/// The constrained Delaunay triangulation of points and segments of the plane: every segment is a chain of edges, and
/// the circle of every triangle has no vertex inside that its inside sees past the segments.
///
/// Segments may cross, overlap, touch and repeat; points may lie on them. Where they cross is a vertex, exactly: a
/// crossing is known by its two segments (`SegmentPieces2`), its coordinates are rationals of degree 3 over 2. Exact
/// for all finite doubles. Ties are decided as in Delaunay2, so the result is a function of the points and segments.
class ConstrainedDelaunay2 {
 public:
  /// O((n + k) log n) expected for k crossings, but quadratic in the triangles that a single segment crosses at worst.
  /// @throws InputError  a point is not finite, a segment has an end that is no point (the first is named), or there
  /// are more than
  ///                     2^29 points and crossings
  /// @throws Cancelled
  ConstrainedDelaunay2(std::span<const Point2> points, std::span<const Segment2> segments,
                       const Context& context = Context());

  /// Of the affine hull of the points: -1, 0, 1 or 2. There are triangles in dimension 2 only.
  int dimension() const { return dimension_; }
  const Triangulation2& links() const { return links_; }

  std::size_t vertex_count() const { return pieces_.table.point_count(); }
  /// Vertices below this number are given points; the others are crossings.
  std::size_t given_count() const { return pieces_.input_begin.size() - 1; }
  /// Given points at a vertex, ascending; none at a crossing.
  std::span<const std::uint32_t> inputs(Vertex2 v) const;
  RationalPoint2 exact(Vertex2 v) const;
  /// Each coordinate rounded to nearest; exact for given points.
  Point2 rounded(Vertex2 v) const;
  /// Turn of three finite vertices, and side of the circle of three on which the fourth lies; exact.
  Sign turn(Vertex2 a, Vertex2 b, Vertex2 c) const;
  Sign circle_side(Vertex2 a, Vertex2 b, Vertex2 c, Vertex2 d) const;

  /// Pieces of segments, each an edge; in dimension 1 too.
  std::span<const SegmentPieces2::Piece> pieces() const { return pieces_.pieces; }
  /// Segments along a piece, as seen from its source.
  std::span<const SegmentUse2> uses(std::size_t piece) const { return pieces_.uses_of(piece); }
  /// The piece that an edge is, if it is one.
  std::optional<std::size_t> piece(Edge2 e) const {
    const std::uint32_t found = piece_of_[3 * e.triangle().index() + e.slot()];
    return found == Vertex2::none_value ? std::nullopt : std::optional<std::size_t>(found);
  }
  bool is_constrained(Edge2 e) const { return piece_of_[3 * e.triangle().index() + e.slot()] != Vertex2::none_value; }

  /// A finite triangle that holds the point, in its closure; none outside of the hull. O(n), exact.
  /// @throws InputError  the point is not finite
  /// @throws Cancelled
  Triangle2 find_triangle(const Point2& query, const Context& context = Context()) const;

 private:
  void mark_pieces();

  SegmentPieces2 pieces_;
  Triangulation2 links_;
  std::vector<std::uint32_t> piece_of_;  // of each side of each triangle
  int dimension_ = -1;
};

}  // namespace quoin
