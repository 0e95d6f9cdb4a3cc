// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"

namespace quoin {

/// Which of some faces, given by their corners without repetitions in a row, are more than a surface needs.
struct SuperfluousFaces {
  std::vector<std::uint32_t> duplicates;  ///< another face of the same outline stays
  std::vector<std::uint32_t> balanced;    ///< as many run one way as the other, and none stays
};

/// The rules are those of `repair_mesh`. Both lists ascend. O(n log n).
SuperfluousFaces find_superfluous_faces(const std::vector<std::vector<std::uint32_t>>& faces, const Context& context);

}  // namespace quoin
