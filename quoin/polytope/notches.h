// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// An edge of a boundary at which the solid is not convex.
struct Notch {
  PointId a;
  PointId b;
  std::vector<std::uint32_t> faces;  ///< those at the edge
  bool is_manifold = true;           ///< two faces meet there; else the solid touches itself along the edge
};

/// All of them. A connected solid without notches is convex. Exact, O(n log n).
std::vector<Notch> find_notches(const Brep& boundary, const Context& context);
/// Whether there is one.
bool has_notch(const Brep& boundary, const Context& context);

}  // namespace quoin
