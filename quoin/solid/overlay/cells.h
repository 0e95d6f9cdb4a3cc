// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/overlay/fans.h"

namespace quoin::overlay {

/// Sheets joined through edges where nothing else meets: all of a patch has the same cell before and behind it.
struct Patch {
  std::uint32_t sheet;  ///< the smallest
  std::uint32_t front;  ///< cell on the side the normals point to
  std::uint32_t back;
};

/// The cells into which all leaf boundaries divide space, as far as edges connect them, and what separates them.
struct CellComplex {
  std::vector<std::uint32_t> patch_of;  ///< per sheet; meaningless for replaced tiles
  std::vector<Patch> patches;
  std::vector<std::uint32_t> patch_first_winding{0};
  std::vector<Winding> windings;  ///< per patch: what changes from its front to its back
  std::uint32_t cell_count = 0;

  std::span<const Winding> windings_across(std::uint32_t patch) const {
    return {windings.data() + patch_first_winding[patch], windings.data() + patch_first_winding[patch + 1]};
  }
};

/// O(sheets) but for inverse-Ackermann factors.
CellComplex make_cells(const Sheets& sheets, const Fans& fans, const Context& context);

}  // namespace quoin::overlay
