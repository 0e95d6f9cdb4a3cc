// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/flow/flow_complex.h"

/// Shared by tests of the flow.
namespace quoin::testing {

inline FlowComplex flow_complex(const std::vector<Point3>& points) {
  const Context context({.threads = 1});
  const Delaunay3 triangulation(points, context);
  return FlowComplex(triangulation, context);
}

}  // namespace quoin::testing
