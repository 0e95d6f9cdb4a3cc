// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/triangulation2.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "quoin/base/error.h"

namespace quoin {

void require_edge_codes(std::size_t vertices) {
  constexpr std::size_t most = std::size_t{1} << 29;
  if (vertices > most) throw InputError(std::to_string(vertices) + " points are more than " + std::to_string(most));
}

namespace {

unsigned smallest_slot(const TriangleLinks2& t) {
  const auto& v = t.corner;
  return v[0] < v[1] ? (v[0] < v[2] ? 0 : 2) : (v[1] < v[2] ? 1 : 2);
}

template <class T>
std::array<T, 3> turned(const std::array<T, 3>& a, unsigned first) {
  return {a[first], a[next_slot(first)], a[previous_slot(first)]};
}

// Slots turn with the corners of the neighbour, so they are known for all before any corner turns.
void turn_smallest_first(TriangleArray2& triangles) {
  LargeVector<std::uint8_t> first(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    first[t] = static_cast<std::uint8_t>(smallest_slot(triangles[t]));
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    TriangleLinks2& triangle = triangles[t];
    for (std::uint32_t& code : triangle.across) {
      const unsigned slot = code % 4;
      const unsigned least = first[code / 4];
      code = code - slot + (slot < least ? slot + 3 - least : slot - least);
    }
    triangle = {turned(triangle.corner, first[t]), turned(triangle.across, first[t])};
  }
}

// The new number of each triangle in the order of their corners, the smallest of which are first in each. There are two
// triangles for each smallest corner on average.
LargeVector<std::uint32_t> canonical_numbers(const TriangleArray2& triangles, std::size_t vertex_count) {
  LargeVector<std::uint32_t> begin(vertex_count + 2, 0);
  for (const TriangleLinks2& t : triangles) ++begin[t.corner[0] + 1];
  for (std::size_t v = 0; v <= vertex_count; ++v) begin[v + 1] += begin[v];
  LargeVector<std::uint32_t> order(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) order[begin[triangles[i].corner[0]]++] = i;
  // begin[v] is now where the triangles of v end. Those that have it as the smallest corner differ in the next.
  LargeVector<std::uint32_t> number(triangles.size());
  std::vector<std::uint64_t> keys;
  std::uint32_t next = 0;
  for (std::size_t v = 0; v <= vertex_count; ++v) {
    keys.clear();
    for (std::uint32_t i = next; i < begin[v]; ++i) {
      keys.push_back(std::uint64_t{triangles[order[i]].corner[1]} << 32 | order[i]);
    }
    std::sort(keys.begin(), keys.end());
    for (const std::uint64_t key : keys) number[static_cast<std::uint32_t>(key)] = next++;
  }
  return number;
}

}  // namespace

Triangulation2::Triangulation2(TriangleArray2 triangles, std::size_t vertex_count, const Context& context)
    : triangles_(std::move(triangles)), vertex_count_(vertex_count) {
  index_edges(context);
}

void Triangulation2::index_edges(const Context& context) {
  edge_from_.assign(vertex_count_ + 1, Vertex2::none_value);
  for (std::uint32_t t = static_cast<std::uint32_t>(triangles_.size()); t-- > 0;) {
    if (t % (1 << 20) == 0) context.poll();
    for (unsigned slot = 0; slot < 3; ++slot) {
      edge_from_[triangles_[t].corner[slot]] = Edge2(Triangle2(t), previous_slot(slot)).code;
    }
  }
}

std::size_t Triangulation2::finite_triangle_count() const {
  std::size_t count = 0;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) count += is_infinite(Triangle2(t)) ? 0 : 1;
  return count;
}

void Triangulation2::renumber() {
  edge_from_ = {};
  turn_smallest_first(triangles_);
  LargeVector<std::uint32_t> number = canonical_numbers(triangles_, vertex_count_);
  for (TriangleLinks2& t : triangles_) {
    for (std::uint32_t& code : t.across) code = 4 * number[code / 4] + code % 4;
  }
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    while (number[i] != i) {
      const std::uint32_t to = number[i];
      std::swap(triangles_[i], triangles_[to]);
      std::swap(number[i], number[to]);
    }
  }
  index_edges(Context({.threads = 1}));
}

const char* Triangulation2::defect() const {
  if (triangles_.empty()) return nullptr;
  if (triangles_.size() != 2 * (vertex_count_ - 1)) return "Euler's relation does not hold";
  std::vector<std::uint32_t> degree(vertex_count_ + 1, 0);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    const Triangle2 t(i);
    for (unsigned slot = 0; slot < 3; ++slot) {
      if (corner(t, slot).index() > vertex_count_) return "a corner is no vertex";
      ++degree[corner(t, slot).index()];
      const Edge2 e(t, slot);
      if (twin(e).slot() > 2 || twin(e).triangle().index() >= triangles_.size()) return "a neighbour is no triangle";
      if (twin(twin(e)) != e) return "neighbours are not mutual";
      if (source(e) != target(twin(e)) || target(e) != source(twin(e))) return "neighbours do not share an edge";
    }
  }
  for (std::uint32_t v = 0; v <= vertex_count_; ++v) {
    if (edge_from(Vertex2(v)).is_none()) return "a vertex has no triangle";
    if (source(edge_from(Vertex2(v))) != Vertex2(v)) return "an edge is not that of its vertex";
    Edge2 e = edge_from(Vertex2(v));
    for (std::uint32_t k = 0; k < degree[v]; ++k) {
      e = around_source(e);
      if ((e == edge_from(Vertex2(v))) != (k + 1 == degree[v])) return "triangles about a vertex are no cycle";
    }
  }
  return nullptr;
}

}  // namespace quoin
