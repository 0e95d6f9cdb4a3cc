// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "quoin/assembly/disassembly.h"

namespace quoin {

/// The best moves of a subassembly found so far: those of fewest parts, of equally many the first found. A set that
/// moves and the rest that moves the other way are one move, of the smaller of the two where both are found.
class MoveList {
 public:
  MoveList(const PartSet& parts, std::size_t most) : parts_(parts), most_(most > 0 ? most : 1) {}

  void add(PartSet moving, const SphereDirection& direction);
  bool is_empty() const { return moves_.empty(); }
  /// As many as are kept, all of single parts.
  bool is_full() const { return moves_.size() >= most_ && moves_.back().moving.count() == 1; }
  /// `has_all` becomes false where some were left out.
  std::vector<DisassemblyMove> take(bool& has_all);

 private:
  PartSet parts_;
  std::size_t most_;
  bool was_cut_ = false;
  std::vector<DisassemblyMove> moves_;  // fewest parts first
};

}  // namespace quoin
