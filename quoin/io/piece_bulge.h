// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/circular/circular_family.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// The bulge of a piece of a branch from its left end to its right one, whose rounded places are given: zero of a line,
/// positive of a lower half, negative of an upper one, at most one in size. Rounded; the sense and the side of the
/// circle are the branch's, however close the ends.
double bulge_between(const CircularFamily& family, BranchId branch, const Point2& left, const Point2& right);

}  // namespace quoin
