// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/arrangement.h"
#include "quoin/arrangement/linear/linear_family.h"
#include "quoin/arrangement/sweep/sweep.h"

namespace quoin {

static_assert(CurveFamily<LinearFamily>);

extern template class Sweep<LinearFamily>;
extern template class Arrangement<LinearFamily>;
extern template Arrangement<LinearFamily> arrange(LinearFamily, const PieceList<LinearFamily>&, const Context&);
extern template Arrangement<LinearFamily> arrange(LinearFamily, PieceList<LinearFamily>&&, const Context&);

using LinearArrangement = Arrangement<LinearFamily>;

}  // namespace quoin
