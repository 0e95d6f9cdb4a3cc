// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/circulators.h"

#include <algorithm>
#include <unordered_set>

namespace quoin {

std::vector<std::uint32_t> VertexStars::star(std::uint32_t vertex) const {
  constexpr std::size_t few = 64;
  std::vector<std::uint32_t> list{first_[vertex]};
  std::unordered_set<std::uint32_t> seen;  // once the list is too long to be searched
  const auto is_seen = [&](std::uint32_t c) {
    if (list.size() < few) return std::find(list.begin(), list.end(), c) != list.end();
    if (seen.empty()) seen.insert(list.begin(), list.end());
    return !seen.insert(c).second;
  };
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::uint32_t c = list[k];
    for (unsigned i = 0; i < size_; ++i) {
      if (cells_[c].vertices[i] == vertex) continue;
      const std::uint32_t next = cells_[c].neighbours[i] >> 2;
      if (!is_seen(next)) list.push_back(next);
    }
  }
  return list;
}

std::vector<std::uint32_t> VertexStars::neighbours(std::uint32_t vertex) const {
  std::vector<std::uint32_t> list;
  for (const std::uint32_t c : star(vertex)) {
    for (unsigned i = 0; i < size_; ++i) {
      const std::uint32_t v = cells_[c].vertices[i];
      if (v != vertex && v != vertex_at_infinity) list.push_back(v);
    }
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

bool VertexStars::is_on_hull(std::uint32_t vertex) const {
  const std::vector<std::uint32_t> cells = star(vertex);
  return std::any_of(cells.begin(), cells.end(),
                     [this](std::uint32_t c) { return cells_[c].vertices[size_ - 1] == vertex_at_infinity; });
}

}  // namespace quoin
