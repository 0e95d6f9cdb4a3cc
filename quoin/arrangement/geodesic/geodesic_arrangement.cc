// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/geodesic/geodesic_arrangement.h"

#include "quoin/arrangement/arrangement_impl.h"

namespace quoin {

template class Sweep<GeodesicFamily>;
template class Arrangement<GeodesicFamily>;
template Arrangement<GeodesicFamily> arrange(GeodesicFamily, const PieceList<GeodesicFamily>&, const Context&);
template Arrangement<GeodesicFamily> arrange(GeodesicFamily, PieceList<GeodesicFamily>&&, const Context&);

}  // namespace quoin
