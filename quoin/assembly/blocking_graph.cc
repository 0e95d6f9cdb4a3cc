// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/blocking_graph.h"

#include <algorithm>
#include <bit>

namespace quoin {

std::size_t BlockingGraph::arc_count() const {
  std::size_t count = 0;
  for (const std::uint64_t word : out_) count += static_cast<std::size_t>(std::popcount(word));
  return count;
}

PartSet BlockingGraph::closure(const Rows& rows, std::uint32_t from, const PartSet& within) const {
  PartSet reached(part_count_);
  reached.insert(from);
  PartSet pending = reached;
  for (std::size_t w = 0; w < words_;) {
    const std::uint64_t rest = pending.words()[w];
    if (rest == 0) {
      ++w;
      continue;
    }
    const std::size_t part = 64 * w + static_cast<std::size_t>(std::countr_zero(rest));
    pending.words()[w] &= rest - 1;
    std::size_t first_new = w;
    for (std::size_t k = 0; k < words_; ++k) {
      const std::uint64_t fresh = rows[part * words_ + k] & within.words()[k] & ~reached.words()[k];
      if (fresh == 0) continue;
      reached.words()[k] |= fresh;
      pending.words()[k] |= fresh;
      first_new = std::min(first_new, k);
    }
    w = first_new;
  }
  return reached;
}

bool BlockingGraph::has_free_part(const PartSet& within) const {
  for (std::size_t w = 0; w < words_; ++w) {
    for (std::uint64_t rest = within.words()[w]; rest != 0; rest &= rest - 1) {
      if (!is_held(64 * w + static_cast<std::size_t>(std::countr_zero(rest)), within)) return true;
    }
  }
  return false;
}

bool BlockingGraph::is_strongly_connected(const PartSet& within) const {
  if (within.has_several() && has_free_part(within)) return false;  // what is quickly found comes first
  for (std::size_t w = 0; w < words_; ++w) {
    if (within.words()[w] == 0) continue;
    const auto part =
        static_cast<std::uint32_t>(64 * w + static_cast<std::size_t>(std::countr_zero(within.words()[w])));
    return closure(out_, part, within) == within && closure(in_, part, within) == within;
  }
  return true;
}

std::vector<PartSet> BlockingGraph::movable_sets(const PartSet& within) const {
  std::vector<PartSet> sets;
  if (is_strongly_connected(within)) return sets;
  for (const std::uint32_t part : within.members()) {
    PartSet set = reachable(part, within);
    if (set != within) sets.push_back(std::move(set));
  }
  std::ranges::sort(sets, [](const PartSet& a, const PartSet& b) {
    const std::size_t size = a.count();
    const std::size_t other = b.count();
    return size != other ? size < other : a < b;
  });
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
  return sets;
}

}  // namespace quoin
