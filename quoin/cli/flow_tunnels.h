// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/flow_grades.h"
#include "quoin/cli/flow_layers.h"
#include "quoin/cli/page_values.h"

namespace quoin::cli {

/// When tunnels come and go, of the alpha complexes of the points, which have the shape of the unions of balls too and
/// change it at the same distances: exact, over two elements. Where one critical point alone can be the cause, it is
/// told. About 330 bytes for each simplex, and the time of the persistence. @throws Cancelled
std::vector<GradedPair> tunnels_of(const FlowGraph& graph, const FlowGrades& grades, const FlowPlaces& places,
                                   const Context& context);

}  // namespace quoin::cli
