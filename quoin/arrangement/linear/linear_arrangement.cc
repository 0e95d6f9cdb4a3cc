// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/linear/linear_arrangement.h"

#include "quoin/arrangement/arrangement_impl.h"

namespace quoin {

template class Sweep<LinearFamily>;
template class Arrangement<LinearFamily>;
template Arrangement<LinearFamily> arrange(LinearFamily, const PieceList<LinearFamily>&, const Context&);
template Arrangement<LinearFamily> arrange(LinearFamily, PieceList<LinearFamily>&&, const Context&);

}  // namespace quoin
