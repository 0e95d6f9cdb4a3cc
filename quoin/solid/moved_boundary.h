// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/kernel/rational_point.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// The boundary moved by a vector, exactly: all its points are explicit then, doubles if all of them are, else
/// rationals. O(n).
Brep moved_boundary(const Brep& boundary, const RationalPoint3& by);

}  // namespace quoin
