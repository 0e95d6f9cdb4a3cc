// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/cli/flow_page.h"
#include "quoin/flow/flat_flow.h"
#include "quoin/io/point_file.h"
#include "quoin/triangulation/delaunay3.h"
#include "quoin/view/layered_scene.h"

namespace quoin::cli {

/// The flow of points of one plane, line or place, as `scene_of_flow` has that of space: critical points by index,
/// those of index 2 being maxima of the plane; a midpoint that is picked shows its edge and its two ways in the plane,
/// a maximum the triangles of the plane that flow to it, the ways that lead to it and their edges, which are around it.
/// Components and holes by distance, and their persistence.
///
/// Which is at most as far as which is exact. Critical points and corners are told to seven digits. Of `page` edges,
/// surfaces, ways (of index 1), distance and what is left out count. @throws Cancelled
LayeredScene scene_of_flat_flow(FlatFlow& flow, const Delaunay3& triangulation, const FlowPage& page,
                                const PointFile& file, const Context& context);

}  // namespace quoin::cli
