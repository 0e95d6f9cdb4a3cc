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

template <CurveFamily F>
Arrangement<F> arrange_sorted(F family, PieceList<F> sorted, const Context& context) {
  BuildVisitor<F> visitor(family, sorted, false);
  Sweep<F>(family, sorted, {}, {}, visitor, context).run();
  sorted = PieceList<F>();  // linking takes memory of its own
  return visitor.finish(std::move(family));
}

}  // namespace arrangement_detail

template <CurveFamily F>
Arrangement<F> arrange(F family, const PieceList<F>& list, const Context& context) {
  PieceList<F> sorted = sorted_list(context, family, list);
  return arrangement_detail::arrange_sorted(std::move(family), std::move(sorted), context);
}

template <CurveFamily F>
Arrangement<F> arrange(F family, PieceList<F>&& list, const Context& context) {
  PieceList<F> sorted = sorted_list(context, family, list);
  list = PieceList<F>();
  return arrangement_detail::arrange_sorted(std::move(family), std::move(sorted), context);
}

}  // namespace quoin
