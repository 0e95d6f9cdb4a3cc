// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/circular/circular_envelope.h"

#include "quoin/arrangement/envelope_impl.h"

namespace quoin {

template CircularEnvelope lower_envelope(const CircularFamily&, const PieceList<CircularFamily>&, const Context&);
template CircularEnvelope upper_envelope(const CircularFamily&, const PieceList<CircularFamily>&, const Context&);

}  // namespace quoin
