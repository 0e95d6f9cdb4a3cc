// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/flat_location.h"

#include <algorithm>

#include "quoin/kernel/predicates2.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/triangulation/affine_basis.h"
#include "quoin/triangulation/circulators.h"

namespace quoin {

FlatLocator::FlatLocator(const TriangulationView3& triangulation) : triangulation_(triangulation) {
  if (triangulation.dimension() < 2) {
    find_line();
    basis_ = {triangulation.point(line_.front()), triangulation.point(line_.back()), {}};
    return;
  }
  std::uint32_t first = 0;
  while (triangulation.is_ghost(first)) ++first;
  const auto& v = triangulation.cells()[first].vertices;
  basis_ = {triangulation.point(v[0]), triangulation.point(v[1]), triangulation.point(v[2])};
  axis_ = normal_axis(basis_[0], basis_[1], basis_[2]);
  turn_ = orientation(projected(basis_[0]), projected(basis_[1]), projected(basis_[2]));
}

void FlatLocator::find_line() {
  const std::span<const TriangulationCell> cells = triangulation_.cells();
  std::uint32_t at = 0;
  while (!triangulation_.is_ghost(at)) ++at;
  if (triangulation_.dimension() == 0) {
    const std::uint32_t cell = cells[at].neighbours[0] >> 2;
    line_ = {cells[cell].vertices[0]};
    cells_ = {at, cell};
    return;
  }
  // Of the two ghosts, which are neighbours, the one at the lesser end.
  at = std::min(at, cells[at].neighbours[0] >> 2, [&](std::uint32_t a, std::uint32_t b) {
    return lexicographically_less(triangulation_.point(cells[a].vertices[0]),
                                  triangulation_.point(cells[b].vertices[0]));
  });
  line_ = {cells[at].vertices[0]};
  cells_ = {at};
  for (at = cells[at].neighbours[1] >> 2; !triangulation_.is_ghost(at);) {
    const unsigned slot = slot_of(cells[at], line_.back());
    cells_.push_back(at);
    line_.push_back(cells[at].vertices[1 - slot]);
    at = cells[at].neighbours[slot] >> 2;
  }
  cells_.push_back(at);
}

bool FlatLocator::spans(const Point3& p) const {
  if (triangulation_.dimension() == 0) return p == basis_[0];
  if (triangulation_.dimension() == 1) return normal_axis(basis_[0], basis_[1], p) == 3;
  return orientation(basis_[0], basis_[1], basis_[2], p) == Sign::zero;
}

std::optional<DelaunayLocation> FlatLocator::walk_in_plane(const Point3& p, std::uint32_t start,
                                                           std::size_t steps) const {
  const std::span<const TriangulationCell> cells = triangulation_.cells();
  const Point2 query = projected(p);
  return walk_at_most(steps, cells, 2, start, [&](std::uint32_t c, unsigned slot) {
    const auto& v = cells[c].vertices;
    return orientation(projected(v[(slot + 1) % 3]), projected(v[(slot + 2) % 3]), query) * turn_;
  });
}

DelaunayLocation FlatLocator::locate_on_line(const Point3& p) const {
  using Kind = DelaunayLocation::Kind;
  if (!spans(p)) return {Kind::outside_affine_hull, 0, 0};
  const auto after = std::ranges::lower_bound(
      line_, p, [](const Point3& a, const Point3& b) { return lexicographically_less(a, b); },
      [this](std::uint32_t v) { return triangulation_.point(v); });
  const auto place = static_cast<std::size_t>(after - line_.begin());
  if (after != line_.end() && triangulation_.point(*after) == p) {
    const std::uint32_t cell = cells_[place > 0 ? place : 1];  // no ghost
    return {Kind::vertex, cell, 1U << slot_of(triangulation_.cells()[cell], *after)};
  }
  if (place == 0 || after == line_.end()) return {Kind::outside, cells_[place], 0x1};
  return {Kind::edge, cells_[place], 0x3};
}

}  // namespace quoin
