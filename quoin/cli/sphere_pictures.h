// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/view/arrangement_picture.h"

namespace quoin::cli {

/// @throws UsageError  naming an output that shows no picture: arrangements on the sphere are written as nothing else
void require_pictures(const Options& options);

/// The arrangement as a globe in every page, flat in every SVG.
void write_sphere_pictures(const GeodesicArrangement& arrangement, const ArrangementPictureOptions& how,
                           const Options& options, const Context& context);

}  // namespace quoin::cli
