// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/circular/circular_family.h"
#include "quoin/view/picture_traits.h"

namespace quoin {

/// Arcs of circles as arcs, segments straight.
template <>
struct PictureTraits<CircularFamily> {
  static PicturePath piece(const CircularFamily& family, BranchId branch, const CircularPoint& left,
                           const CircularPoint& right, const PictureBox& reach);
};

}  // namespace quoin
