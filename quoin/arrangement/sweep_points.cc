// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sweep_points.h"

namespace quoin {

PointIncidences::PointIncidences(std::size_t point_count, std::span<const Piece> pieces)
    : begin_(point_count + 1, 0), entries_(2 * pieces.size()) {
  for (const Piece& piece : pieces) {
    ++begin_[piece.left + 1];
    ++begin_[piece.right + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto piece = static_cast<std::uint32_t>(i);
    entries_[next[pieces[i].left]++] = 2 * piece;
    entries_[next[pieces[i].right]++] = 2 * piece + 1;
  }
}

}  // namespace quoin
