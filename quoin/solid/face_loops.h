// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "quoin/solid/brep.h"

namespace quoin {

/// Calls visit(loop) for each loop of a face that has an area: all but edges and vertices that touch it.
template <class Visit>
void for_each_ring(const Brep& boundary, std::uint32_t face, const Visit& visit) {
  for (std::uint32_t l = boundary.face_first_loop[face]; l < boundary.face_first_loop[face + 1]; ++l) {
    if (boundary.loop(l).size() >= 3) visit(boundary.loop(l));
  }
}

}  // namespace quoin
