// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/arrangement.h"
#include "quoin/arrangement/circular/circular_family.h"
#include "quoin/arrangement/sweep/sweep.h"

namespace quoin {

extern template class Sweep<CircularFamily>;
extern template class Arrangement<CircularFamily>;
extern template Arrangement<CircularFamily> arrange(CircularFamily, const PieceList<CircularFamily>&, const Context&);
extern template Arrangement<CircularFamily> arrange(CircularFamily, PieceList<CircularFamily>&&, const Context&);

using CircularArrangement = Arrangement<CircularFamily>;

}  // namespace quoin
