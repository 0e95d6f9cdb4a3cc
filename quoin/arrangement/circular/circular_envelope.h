// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/circular/circular_family.h"
#include "quoin/arrangement/envelope.h"

namespace quoin {

using CircularEnvelope = Envelope<CircularFamily>;

extern template CircularEnvelope lower_envelope(const CircularFamily&, const PieceList<CircularFamily>&,
                                                const Context&);
extern template CircularEnvelope upper_envelope(const CircularFamily&, const PieceList<CircularFamily>&,
                                                const Context&);

}  // namespace quoin
