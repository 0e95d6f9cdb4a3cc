// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay3.h"

#include <algorithm>
#include <array>
#include <new>

#include "quoin/triangulation/affine_basis.h"
#include "quoin/triangulation/canonical_cells.h"
#include "quoin/triangulation/delaunay_cells.h"
#include "quoin/triangulation/flat_cells.h"
#include "quoin/triangulation/insertion_rounds.h"

namespace quoin {

Delaunay3::Delaunay3(std::span<const Point3> points, const Context& context, const DelaunayOptions& options) try
    : points_(points, Scaling::allowed, context), vertex_count_(points_.points.size()) {
  const AffineBasis basis = affine_basis(points_.all(), context);
  dimension_ = static_cast<int>(basis.vertices.size()) - 1;
  if (dimension_ < 2) {
    cells_ = cells_of_chain(chain());
  } else {
    const bool is_plain = options.is_canonical && context.threads() < 2;
    triangulate(basis, is_plain ? InsertionSplit::none() : InsertionSplit::of(vertex_count_), context);
  }
  if (options.is_canonical) sort_cells(cells_, dimension_);
} catch (const std::bad_alloc&) {
  refuse_for_memory(points.size());
}

void Delaunay3::triangulate(const AffineBasis& basis, const InsertionSplit& split, const Context& context) {
  const auto apex = static_cast<std::uint32_t>(vertex_count_);
  const std::vector<std::uint32_t>& v = basis.vertices;
  if (dimension_ == 2) points_.points.push_back(point_off_plane(points_.all(), basis));
  cells_ = delaunay_cells(signs(), vertex_count_, {v[0], v[1], v[2], dimension_ == 2 ? apex : v[3]}, split, context);
  if (dimension_ == 2) cells_ = without_apex(cells_, apex);
}

std::vector<std::uint32_t> Delaunay3::chain() const {
  std::vector<std::uint32_t> chain(vertex_count_);
  for (std::uint32_t v = 0; v < vertex_count_; ++v) chain[v] = v;
  std::sort(chain.begin(), chain.end(), [this](std::uint32_t a, std::uint32_t b) {
    return lexicographically_less(points_.points[a], points_.points[b]);
  });
  return chain;
}

std::size_t Delaunay3::finite_cell_count() const {
  std::size_t count = 0;
  for (std::size_t c = 0; c < cells_.size(); ++c) count += is_ghost(c) ? 0 : 1;
  return count;
}

int Delaunay3::in_sphere(const DelaunaySigns& signs, std::size_t cell, std::uint32_t vertex) const {
  const std::array<std::uint32_t, 4>& v = cells_[cell].vertices;
  if (dimension_ == 3) return signs.in_sphere(v[0], v[1], v[2], v[3], vertex);
  if (dimension_ == 2) return signs.in_sphere(v[0], v[1], v[2], static_cast<std::uint32_t>(vertex_count_), vertex);
  for (unsigned i = 0; i <= static_cast<unsigned>(dimension_); ++i) {
    if (v[i] == vertex) return 0;
  }
  if (dimension_ == 0) return -1;
  // On a line the order of coordinates is that along it.
  const bool is_after = lexicographically_less(points_.points[v[0]], points_.points[vertex]);
  return is_after == lexicographically_less(points_.points[vertex], points_.points[v[1]]) ? 1 : -1;
}

}  // namespace quoin
