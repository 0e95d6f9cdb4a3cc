// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/cli/options.h"
#include "quoin/view/arrangement_picture.h"

namespace quoin::cli {

/// @throws UsageError  naming an output that is no page: arrangements on the sphere are written as nothing else
void require_sphere_pages(const Options& options);

/// The arrangement as a globe in every output.
void write_sphere_pages(const GeodesicArrangement& arrangement, const ArrangementPictureOptions& how,
                        const Options& options);

}  // namespace quoin::cli
