// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/arrangement.h"
#include "quoin/arrangement/sweep/build_visitor.h"
#include "quoin/arrangement/sweep/sweep_impl.h"

/// Bodies of Arrangement, for the one source file per family that instantiates it.
namespace quoin {

template <CurveFamily F>
Arrangement<F>::Arrangement() {
  cells_ = dcel::DcelBuilder().finish(F::Surface::sides, F::Surface::has_unbounded_face).dcel;
}

namespace arrangement_detail {

enum class CrossingSearch : std::uint8_t { as_fits, along_the_sweep };

/// For the cells that a list of so many points and pieces mostly has, where arrays are so large that the system gives
/// memory only for what is used of them: growing by doubling would touch twice as much.
template <CurveFamily F>
void reserve_likely(BuildVisitor<F>& visitor, const PieceList<F>& list) {
  constexpr std::size_t large = std::size_t{1} << 15;
  if (list.pieces.size() >= large) visitor.reserve(3 * list.points.size(), 3 * list.pieces.size());
}

/// Where all crossings are known, arrays get their sizes at once.
template <CurveFamily F>
void sweep_into(BuildVisitor<F>& visitor, const F& family, const PieceList<F>& sorted, CrossingSearch search,
                const Context& context) {
  Sweep<F> sweep(family, sorted, {}, {}, visitor, context);
  if constexpr (PairwiseFamily<F>) {
    CrossingList<typename F::Point> crossings;
    if (search == CrossingSearch::as_fits && family.find_crossings(sorted, context, crossings)) {
      sweep.take_crossings(crossings);
      visitor.reserve(sorted.points.size() + crossings.points.size(),
                      sorted.pieces.size() + 2 * crossings.points.size());
      sweep.run();
      return;
    }
  }
  reserve_likely(visitor, sorted);
  sweep.run();
}

template <CurveFamily F>
Arrangement<F> arrange_sorted(F family, PieceList<F> sorted, CrossingSearch search, const Context& context) {
  BuildVisitor<F> visitor(family, sorted, false);
  sweep_into(visitor, family, sorted, search, context);
  sorted = PieceList<F>();  // linking takes memory of its own
  return visitor.finish(std::move(family));
}

}  // namespace arrangement_detail

template <CurveFamily F>
Arrangement<F> arrange(F family, const PieceList<F>& list, const Context& context) {
  PieceList<F> sorted = sorted_list(context, family, list);
  return arrangement_detail::arrange_sorted(std::move(family), std::move(sorted),
                                            arrangement_detail::CrossingSearch::as_fits, context);
}

template <CurveFamily F>
Arrangement<F> arrange(F family, PieceList<F>&& list, const Context& context) {
  PieceList<F> sorted = sorted_list(context, family, std::move(list));
  return arrangement_detail::arrange_sorted(std::move(family), std::move(sorted),
                                            arrangement_detail::CrossingSearch::as_fits, context);
}

}  // namespace quoin
