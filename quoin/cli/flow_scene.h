// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/cli/flow_page.h"
#include "quoin/flow/flow_graph.h"
#include "quoin/io/point_file.h"
#include "quoin/view/layered_scene.h"

namespace quoin::cli {

/// Critical points of space by index, from their distance on, and what flows to and from them; a saddle or maximum
/// that is picked shows what is its own: a saddle its surface and its ways, a maximum the ways to it and the surfaces
/// around its region. Numbers of critical points and Betti numbers by distance, and the persistence of components and
/// voids.
///
/// Which is at most as far as which is exact. Critical points are told to seven digits; corners of surfaces and ways
/// are drawn within a part in four thousand of the size.
/// @throws Cancelled
LayeredScene scene_of_flow(const FlowGraph& graph, const FlowPage& page, const PointFile& file, const Context& context);

}  // namespace quoin::cli
