// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/arrangement.h"
#include "quoin/arrangement/edit/observer.h"
#include "quoin/arrangement/edit/zone.h"

namespace quoin {

template <class Point>
struct InsertOptions {
  /// From so many pieces on, everything is swept anew.
  std::size_t sweeps_from = 32;
  /// Finds left ends; must follow the changes. None: naive location, linear in the arrangement.
  ZoneLocator<Point> locate{};
};

/// Adds the curves of a list to an arrangement; `family` holds the list's supports, which the arrangement takes over.
/// Returns the id of the list's curve 0 in the history; the others follow it.
///
/// Few pieces are inserted one by one along their zones, many by `insert_many`. Exact; the result does not depend on
/// the order of insertions but for ids, see `renumber`. On surfaces with glued or contracted sides always by sweep.
/// @throws Cancelled  what was inserted before stays, if by zones
template <CurveFamily F>
CurveId insert(Arrangement<F>& arrangement, const F& family, const PieceList<F>& list, const Context& context,
               const InsertOptions<typename F::Point>& options = {});

/// Sweeps the edges of an arrangement, which are known not to cross, together with new curves. One global change for
/// observers; cells are numbered anew in canonical order. O((n + k) log n). On every surface.
/// @throws Cancelled  the arrangement is untouched
template <CurveFamily F>
CurveId insert_many(Arrangement<F>& arrangement, const F& family, const PieceList<F>& list, const Context& context);

/// Drops dead cells and numbers the others canonically: vertices in lexicographic order, edges by their left vertex and
/// from bottom to top, faces as a construction numbers them. Two arrangements of the same curves get the same ids,
/// however they came about. One global change for observers. O(n log n).
template <CurveFamily F>
CellMap renumber(Arrangement<F>& arrangement, const Context& context);

struct RemoveCurveOptions {
  /// Edges at vertices that only split one curve now are merged. Without, the vertices stay.
  bool merges_edges = true;
};

/// Takes a curve out of the history, and the edges that no other curve induces out of the arrangement. Ends left alone
/// go, and vertices that the curve had cut into another one. Curve ids stay. O(size).
///
/// Vertices keep no history: a point given on an edge, or a vertex inside a straight run of one polyline, goes too if
/// the removed curve met it; isolated points stay.
template <CurveFamily F>
void remove_curve(Arrangement<F>& arrangement, CurveId curve, const RemoveCurveOptions& options = {});

}  // namespace quoin
