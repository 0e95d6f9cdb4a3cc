// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/circulators.h"

#include <algorithm>
#include <unordered_set>

namespace quoin {

namespace {

constexpr std::size_t few = 64;  // members of a list that is searched from end to end

/// Without a way out of the loop, which takes several at a time then.
bool holds(const std::vector<std::uint32_t>& list, std::uint32_t member) {
  bool is_there = false;
  for (const std::uint32_t other : list) is_there |= other == member;
  return is_there;
}

}  // namespace

void find_star(std::span<const TriangulationCell> cells, unsigned size, std::uint32_t vertex, std::uint32_t first,
               std::vector<std::uint32_t>& list, const Context* context) {
  list.assign(1, first);
  std::unordered_set<std::uint32_t> seen;  // once the list is too long to be searched
  const auto is_seen = [&](std::uint32_t c) {
    if (list.size() < few) return holds(list, c);
    if (seen.empty()) seen.insert(list.begin(), list.end());
    return !seen.insert(c).second;
  };
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (context != nullptr && k % 1024 == 1023) context->poll();
    const std::uint32_t c = list[k];
    for (unsigned i = 0; i < size; ++i) {
      if (cells[c].vertices[i] == vertex) continue;
      const std::uint32_t next = cells[c].neighbours[i] >> 2;
      if (!is_seen(next)) list.push_back(next);
    }
  }
}

void find_link_vertices(std::span<const TriangulationCell> cells, unsigned size, std::uint32_t vertex,
                        std::span<const std::uint32_t> star, std::vector<std::uint32_t>& list) {
  list.clear();
  for (const std::uint32_t c : star) {
    for (unsigned i = 0; i < size; ++i) {
      const std::uint32_t v = cells[c].vertices[i];
      if (v == vertex || v == vertex_at_infinity || (list.size() < few && holds(list, v))) continue;
      list.push_back(v);
    }
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

VertexStars::VertexStars(const TriangulationView3& triangulation)
    : cells_(triangulation.cells()), size_(static_cast<unsigned>(triangulation.dimension()) + 1) {
  first_.assign(triangulation.vertex_count(), no_cell);
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    for (unsigned i = 0; i < size_; ++i) {
      if (cells_[c].vertices[i] != vertex_at_infinity) first_[cells_[c].vertices[i]] = c;
    }
  }
}

std::vector<std::uint32_t> VertexStars::star(std::uint32_t vertex) const {
  std::vector<std::uint32_t> list;
  find_star(cells_, size_, vertex, first_[vertex], list);
  return list;
}

std::vector<std::uint32_t> VertexStars::neighbours(std::uint32_t vertex) const {
  std::vector<std::uint32_t> list;
  find_link_vertices(cells_, size_, vertex, star(vertex), list);
  return list;
}

bool VertexStars::is_on_hull(std::uint32_t vertex) const {
  const std::vector<std::uint32_t> cells = star(vertex);
  return std::any_of(cells.begin(), cells.end(),
                     [this](std::uint32_t c) { return cells_[c].vertices[size_ - 1] == vertex_at_infinity; });
}

}  // namespace quoin
