// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/solid/solid.h"

namespace quoin {

enum class Interference : std::uint8_t {
  apart,       ///< no common point
  touching,    ///< common points, but none inside both
  overlapping  ///< common points inside both; also when one contains the other
};

/// What two solids have in common.
struct InterferenceReport {
  Interference kind = Interference::apart;
  Solid common;  ///< their regularized intersection; empty unless they overlap
};

/// Whether two evaluated solids interfere. Exact: touching in a single point is told from missing by 2^-1000. Costs an
/// intersection, and where that is empty, the edges of each boundary against the faces of the other near them.
InterferenceReport interference(const Solid& a, const Solid& b, const Context& context);

}  // namespace quoin
