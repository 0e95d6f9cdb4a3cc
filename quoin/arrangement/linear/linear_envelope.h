// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/envelope.h"
#include "quoin/arrangement/linear/linear_family.h"

namespace quoin {

using LinearEnvelope = Envelope<LinearFamily>;

extern template LinearEnvelope lower_envelope(const LinearFamily&, const PieceList<LinearFamily>&, const Context&);
extern template LinearEnvelope upper_envelope(const LinearFamily&, const PieceList<LinearFamily>&, const Context&);

}  // namespace quoin
