// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_triangles2.h"

#include <utility>

namespace quoin::detail {

VertexStar2 ChangingTriangles2::star(Vertex2 v) const {
  VertexStar2 star;
  std::uint32_t code = edge_from_[v.index()];
  do {
    const TriangleLinks2& t = triangles_[code / 4];
    star.triangles.push_back(code / 4);
    star.corners.push_back(t.corner[previous_slot(code % 4)]);
    star.outer.push_back(t.across[next_slot(code % 4)]);
    code = t.across[previous_slot(code % 4)];
  } while (code != edge_from_[v.index()]);
  return star;
}

void ChangingTriangles2::reserve_vertices(std::size_t count) {
  if (edge_from_.size() >= count) return;
  if (edge_from_.capacity() < count) edge_from_.reserve(2 * count);
  edge_from_.resize(count, Vertex2::none_value);
}

void ChangingTriangles2::assign(TriangleArray2 triangles) {
  triangles_ = std::move(triangles);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) update_edges(t);
}

void ChangingTriangles2::update_edges(std::uint32_t triangle) {
  for (unsigned slot = 0; slot < 3; ++slot) {
    edge_from_[triangles_[triangle].corner[slot]] = 4 * triangle + previous_slot(slot);
  }
}

void ChangingTriangles2::drop(std::uint32_t triangle) {
  close_hole(triangles_, triangle);
  if (triangle < triangles_.size()) update_edges(triangle);
}

TriangleRollback::TriangleRollback(TriangleArray2& triangles, std::span<const std::uint32_t> replaced)
    : triangles_(triangles), count_(triangles.size()), ids_(replaced.begin(), replaced.end()) {
  links_.reserve(ids_.size());
  for (const std::uint32_t t : ids_) links_.push_back(triangles_[t]);
}

TriangleRollback::~TriangleRollback() {
  if (is_kept_) return;
  triangles_.resize(count_);
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    triangles_[ids_[i]] = links_[i];
    for (unsigned slot = 0; slot < 3; ++slot) {
      const std::uint32_t other = links_[i].across[slot];
      triangles_[other / 4].across[other % 4] = 4 * ids_[i] + slot;
    }
  }
}

}  // namespace quoin::detail
