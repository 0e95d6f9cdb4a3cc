// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "quoin/arrangement/cells/dcel.h"
#include "quoin/arrangement/cells/history.h"
#include "quoin/arrangement/edit/observer.h"
#include "quoin/arrangement/pieces.h"
#include "quoin/base/context.h"

namespace quoin {

template <CurveFamily F>
class ArrangementEditor;

/// End points of an edge along its branch, where they are other copies than the points of its vertices.
template <class Point>
struct EdgeEnds {
  dcel::EdgeId edge;
  Point left;
  Point right;
};

/// A subdivision of a surface by curves of one family: the family owns all numbers, the cells are plain links, and an
/// edge is a branch between two vertices.
///
/// Faces of the plane have one outer boundary, but unbounded ones of a plane without curves at infinity none; faces of
/// a sphere have any number of boundaries. Iterate over ids 0 ... size - 1 and skip cells that are not `is_real`.
template <CurveFamily F>
class Arrangement {
 public:
  using Family = F;
  using Point = typename F::Point;

  /// The empty arrangement: one face.
  Arrangement();
  Arrangement(F family, dcel::Dcel cells, std::vector<Point> points, std::vector<BranchId> branches,
              CurveHistory history, std::uint32_t curve_count)
      : family_(std::move(family)),
        cells_(std::move(cells)),
        points_(std::move(points)),
        branches_(std::move(branches)),
        history_(std::move(history)),
        curve_count_(curve_count) {}

  const F& family() const { return family_; }
  const dcel::Dcel& cells() const { return cells_; }
  dcel::Counts counts() const { return dcel::count_cells(cells_); }

  std::size_t vertex_count() const { return cells_.vertices.size(); }
  std::size_t edge_count() const { return cells_.edges.size(); }
  std::size_t face_count() const { return cells_.faces.size(); }

  /// Of a vertex, fictitious ones (ends at infinity) too, but for the four corners of the frame.
  const Point& point(dcel::VertexId v) const { return points_[v.index()]; }
  bool has_point(dcel::VertexId v) const {
    return v.index() < points_.size() && (cells_.is_real(v) || family_.side(point(v)) != Side::interior);
  }
  /// Of a real edge.
  BranchId branch(dcel::EdgeId e) const { return branches_[e.index()]; }
  dcel::VertexId left(dcel::EdgeId e) const { return cells_.origin(dcel::HalfedgeId(e, false)); }
  dcel::VertexId right(dcel::EdgeId e) const { return cells_.origin(dcel::HalfedgeId(e, true)); }
  /// Ends of a piece along its branch. On a sphere they may be other copies than the vertices' points: the copy on the
  /// right side, and the end at a pole with the meridian of this edge.
  const Point& left_point(dcel::EdgeId e) const {
    const EdgeEnds<Point>* own = own_ends(e);
    return own == nullptr ? point(left(e)) : own->left;
  }
  const Point& right_point(dcel::EdgeId e) const {
    const EdgeEnds<Point>* own = own_ends(e);
    return own == nullptr ? point(right(e)) : own->right;
  }
  /// Of edges that end on a glued side; null for others.
  const EdgeEnds<Point>* own_ends(dcel::EdgeId e) const {
    if (edge_ends_.empty()) return nullptr;
    const auto found =
        std::lower_bound(edge_ends_.begin(), edge_ends_.end(), e,
                         [](const EdgeEnds<Point>& ends, dcel::EdgeId edge) { return ends.edge < edge; });
    return found != edge_ends_.end() && found->edge == e ? &*found : nullptr;
  }

  std::uint32_t curve_count() const { return curve_count_; }
  /// Input curves that pass along a real edge.
  std::span<const CurveUse> curves(dcel::EdgeId e) const { return history_.of(e); }
  const CurveHistory& history() const { return history_; }

  /// For algorithms that name curves anew.
  void set_history(CurveHistory history, std::uint32_t curve_count) {
    history_ = std::move(history);
    curve_count_ = curve_count;
  }
  /// Tells the observer of every change from now on, until it is detached.
  void attach(ArrangementObserver& observer) { observers_.attach(observer, cells_); }

  /// Where surfaces have glued sides, edges that end there keep their own end points; sorted by edge.
  void set_edge_ends(std::vector<EdgeEnds<Point>> ends) { edge_ends_ = std::move(ends); }

 private:
  friend class ArrangementEditor<F>;
  F family_;
  dcel::Dcel cells_;
  std::vector<Point> points_;
  std::vector<BranchId> branches_;
  CurveHistory history_;
  std::uint32_t curve_count_ = 0;
  std::vector<EdgeEnds<Point>> edge_ends_;
  ObserverList observers_;
};

/// The arrangement of all pieces and lone points of a list, by one sweep; curve k of the list is curve k of the
/// history.
///
/// Exact; overlapping, touching, multiple and vertical curves are ordinary. O((n + k) log n).
/// @throws Cancelled
template <CurveFamily F>
Arrangement<F> arrange(F family, const PieceList<F>& list, const Context& context);
/// The same of a list that is not needed any more: it is empty afterwards, and its memory is free while the sweep runs.
template <CurveFamily F>
Arrangement<F> arrange(F family, PieceList<F>&& list, const Context& context);

}  // namespace quoin
