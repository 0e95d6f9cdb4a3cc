// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/circular/circular_arrangement.h"

#include "quoin/arrangement/arrangement_impl.h"

namespace quoin {

template class Sweep<CircularFamily>;
template class Arrangement<CircularFamily>;
template Arrangement<CircularFamily> arrange(CircularFamily, const PieceList<CircularFamily>&, const Context&);
template Arrangement<CircularFamily> arrange(CircularFamily, PieceList<CircularFamily>&&, const Context&);

}  // namespace quoin
