// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/view/scene.h"

namespace quoin {

/// @throws InputError  a coordinate or plane is not finite, an index is out of range, or array lengths disagree; names
///                     the part and the element. O(n).
void check_scene(const ViewScene& scene);

}  // namespace quoin
