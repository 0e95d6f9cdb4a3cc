// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/solid/overlay/truth.h"

namespace quoin::overlay {

/// What becomes of a patch.
enum class Fate : std::uint8_t { dropped, kept, reversed };

/// Which sheets separate a cell inside from one outside, and whether their normals point outward.
class KeptSheets {
 public:
  KeptSheets(const CellComplex& complex, const CellTruth& truth) : complex_(&complex) {
    fates_.reserve(complex.patches.size());
    for (const Patch& patch : complex.patches) {
      const bool front = truth.inside[patch.front] != 0;
      const bool back = truth.inside[patch.back] != 0;
      fates_.push_back(front == back ? Fate::dropped : back ? Fate::kept : Fate::reversed);
    }
  }

  Fate fate(std::uint32_t sheet) const {
    const std::uint32_t patch = complex_->patch_of[sheet];
    return patch == none ? Fate::dropped : fates_[patch];
  }
  bool is_kept(std::uint32_t sheet) const { return fate(sheet) != Fate::dropped; }
  bool is_reversed(std::uint32_t sheet) const { return fate(sheet) == Fate::reversed; }
  bool is_kept_patch(std::uint32_t patch) const { return fates_[patch] != Fate::dropped; }

 private:
  const CellComplex* complex_;
  std::vector<Fate> fates_;  // per patch
};

}  // namespace quoin::overlay
