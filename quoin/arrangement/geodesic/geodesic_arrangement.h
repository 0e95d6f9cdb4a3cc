// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/arrangement.h"
#include "quoin/arrangement/geodesic/geodesic_family.h"
#include "quoin/arrangement/sweep/sweep.h"

namespace quoin {

extern template class Sweep<GeodesicFamily>;
extern template class Arrangement<GeodesicFamily>;
extern template Arrangement<GeodesicFamily> arrange(GeodesicFamily, const PieceList<GeodesicFamily>&, const Context&);
extern template Arrangement<GeodesicFamily> arrange(GeodesicFamily, PieceList<GeodesicFamily>&&, const Context&);

using GeodesicArrangement = Arrangement<GeodesicFamily>;

}  // namespace quoin
