// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/edit/local_edits.h"
#include "quoin/arrangement/location/edge_order.h"

namespace quoin {

/// Where a new branch leaves a vertex.
struct RingSearch {
  dcel::RingPlace place;    ///< of its edge, unless
  dcel::EdgeId overlapped;  ///< it runs along this one
};

/// Exact answers about cells that no links tell: which way a cycle turns, what lies inside it, places in rings, and
/// what lies just below a point. Works for the open parts of every surface; cycles in the plane only.
///
/// What is below a point is meant as in edge_order.h: verticals need no rules of their own.
template <CurveFamily F>
class CellGeometry : public dcel::CycleGeometry {
 public:
  using Point = typename F::Point;

  explicit CellGeometry(const Arrangement<F>& arrangement) : arrangement_(arrangement) {}

  // O(length of the cycle).
  bool is_outer(dcel::HalfedgeId on_cycle) const override;
  bool contains(dcel::HalfedgeId on_cycle, dcel::VertexId v) const override;

  /// Places for a branch through the vertex, to the right or to the left of it. O(degree).
  RingSearch place_right(dcel::VertexId v, BranchId branch) const;
  RingSearch place_left(dcel::VertexId v, BranchId branch) const;

  bool is_corner(dcel::VertexId v) const {
    return cells().vertices[v.index()].state == dcel::CellState::fictitious && !arrangement_.has_point(v);
  }
  /// The bottom left corner of the frame; none if the plane has no frame. O(1) on fresh arrangements, else O(vertices).
  dcel::VertexId first_corner() const;
  /// The frame's halfedge, with the plane on its left, on which an end at infinity lies, and the vertex if there is
  /// one.
  struct FramePlace {
    dcel::HalfedgeId edge;
    dcel::VertexId vertex;
  };
  /// O(ends at infinity). The plane must have a frame.
  FramePlace frame_place(const Point& end) const;

 private:
  const dcel::Dcel& cells() const { return arrangement_.cells(); }
  const F& family() const { return arrangement_.family(); }
  bool is_before(const Point& p, const Point& q) const { return family().compare_xy(p, q) == Sign::negative; }
  bool bottom_edge_spans(dcel::HalfedgeId h, const Point& p) const;
  dcel::HalfedgeId next_on_frame(dcel::HalfedgeId h) const;
  dcel::RingPlace after(dcel::VertexId v, dcel::HalfedgeId out) const { return {v, cells().previous(out)}; }

  const Arrangement<F>& arrangement_;
};

}  // namespace quoin
