// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/arrangement.h"
#include "quoin/arrangement/build_visitor.h"
#include "quoin/arrangement/sweep_impl.h"

/// Bodies of Arrangement, for the one source file per family that instantiates it.
namespace quoin {

template <CurveFamily F>
Arrangement<F>::Arrangement() {
  cells_ = dcel::DcelBuilder().finish(F::Surface::sides, F::Surface::has_unbounded_face).dcel;
}

template <CurveFamily F>
Arrangement<F> arrange(F family, const PieceList<F>& list, const Context& context) {
  const PieceList<F> sorted = sorted_list(context, family, list);
  BuildVisitor<F> visitor(family, sorted);
  Sweep<F>(family, sorted, {}, {}, visitor, context).run();
  return visitor.finish(std::move(family));
}

}  // namespace quoin
