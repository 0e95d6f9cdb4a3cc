// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/move_list.h"

#include <algorithm>
#include <utility>

namespace quoin {

void MoveList::add(PartSet moving, const SphereDirection& direction) {
  const PartSet rest = parts_.without(moving);
  const auto known = std::ranges::find_if(
      moves_, [&](const DisassemblyMove& move) { return move.moving == moving || move.moving == rest; });
  const std::size_t count = moving.count();
  if (known != moves_.end()) {
    if (known->moving.count() <= count) return;
    moves_.erase(known);
  }
  const auto after =
      std::ranges::upper_bound(moves_, count, {}, [](const DisassemblyMove& move) { return move.moving.count(); });
  moves_.insert(after, DisassemblyMove{std::move(moving), direction});
  if (moves_.size() > most_) {
    moves_.pop_back();
    was_cut_ = true;
  }
}

std::vector<DisassemblyMove> MoveList::take(bool& has_all) {
  has_all = has_all && !was_cut_;
  return std::move(moves_);
}

}  // namespace quoin
