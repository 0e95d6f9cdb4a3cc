// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/triangulation2.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace quoin {

namespace {

void rotate_to_smallest(TriangleLinks2& t) {
  const auto least = std::min_element(t.corner.begin(), t.corner.end()) - t.corner.begin();
  std::rotate(t.corner.begin(), t.corner.begin() + least, t.corner.end());
  std::rotate(t.across.begin(), t.across.begin() + least, t.across.end());
}

unsigned smallest_slot(const TriangleLinks2& t) {
  return static_cast<unsigned>(std::min_element(t.corner.begin(), t.corner.end()) - t.corner.begin());
}

// The triangles in the order of their corners.
LargeVector<std::uint32_t> canonical_order(const LargeVector<TriangleLinks2>& triangles, std::size_t vertex_count) {
  std::vector<std::uint32_t> begin(vertex_count + 2, 0);
  const auto least = [&](const TriangleLinks2& t) { return t.corner[smallest_slot(t)]; };
  for (const TriangleLinks2& t : triangles) ++begin[least(t) + 1];
  for (std::size_t v = 0; v <= vertex_count; ++v) begin[v + 1] += begin[v];
  LargeVector<std::uint32_t> order(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) order[begin[least(triangles[i])]++] = i;
  const auto second = [&](std::uint32_t i) { return triangles[i].corner[next_slot(smallest_slot(triangles[i]))]; };
  // begin[v] is now where the triangles of v end. Those that have it as the smallest corner differ in the next.
  std::uint32_t start = 0;
  for (std::size_t v = 0; v <= vertex_count; ++v) {
    std::sort(order.begin() + start, order.begin() + begin[v],
              [&](std::uint32_t a, std::uint32_t b) { return second(a) < second(b); });
    start = begin[v];
  }
  return order;
}

}  // namespace

Triangulation2::Triangulation2(LargeVector<TriangleLinks2> triangles, std::size_t vertex_count)
    : triangles_(std::move(triangles)), vertex_count_(vertex_count) {
  index_edges();
}

void Triangulation2::index_edges() {
  edge_from_.assign(vertex_count_ + 1, Vertex2::none_value);
  for (std::uint32_t t = static_cast<std::uint32_t>(triangles_.size()); t-- > 0;) {
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
  LargeVector<std::uint32_t> new_id(triangles_.size());
  {
    const LargeVector<std::uint32_t> order = canonical_order(triangles_, vertex_count_);
    for (std::uint32_t i = 0; i < order.size(); ++i) new_id[order[i]] = i;
  }
  // Slots turn with the corners of the neighbour, so they are found before any corner turns.
  for (TriangleLinks2& t : triangles_) {
    for (std::uint32_t& code : t.across) {
      const std::uint32_t other = code / 4;
      const unsigned slot = (code % 4 + 3 - smallest_slot(triangles_[other])) % 3;
      code = 4 * new_id[other] + slot;
    }
  }
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    while (new_id[i] != i) {
      const std::uint32_t to = new_id[i];
      std::swap(triangles_[i], triangles_[to]);
      std::swap(new_id[i], new_id[to]);
    }
    rotate_to_smallest(triangles_[i]);
  }
  index_edges();
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
