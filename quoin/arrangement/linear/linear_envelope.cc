// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/linear/linear_envelope.h"

#include "quoin/arrangement/envelope_impl.h"

namespace quoin {

template LinearEnvelope lower_envelope(const LinearFamily&, const PieceList<LinearFamily>&, const Context&);
template LinearEnvelope upper_envelope(const LinearFamily&, const PieceList<LinearFamily>&, const Context&);

}  // namespace quoin
