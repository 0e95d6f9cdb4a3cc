// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/delone_faces.h"

#include <algorithm>
#include <numeric>

namespace quoin {

namespace {

/// Lists of values by key, from pairs given in order of values: where each list begins, and all of them.
template <class Value, class ForEach>
void group(std::size_t keys, std::vector<std::size_t>& begin, std::vector<Value>& list, const ForEach& for_each) {
  begin.assign(keys + 1, 0);
  for_each([&](std::uint32_t key, const Value&) { ++begin[key + 1]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  list.resize(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for_each([&](std::uint32_t key, const Value& value) { list[next[key]++] = value; });
}

}  // namespace

DeloneFaces::DeloneFaces(const Delaunay3& triangulation, const Context& context)
    : dimension_(triangulation.dimension()), vertices_(triangulation.vertex_count()) {
  std::iota(vertices_.begin(), vertices_.end(), 0U);
  const DeloneComplex complex(triangulation, context);
  edges_.assign(complex.edges().begin(), complex.edges().end());
  if (dimension_ == 3) take_space(complex);
  if (dimension_ == 2) take_plane(complex);
  find_sides(context);
  find_incidences();
}

void DeloneFaces::take_space(const DeloneComplex& complex) {
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    const std::span<const std::uint32_t> polygon = complex.facet(f);
    corners_.insert(corners_.end(), polygon.begin(), polygon.end());
    polygon_begin_.push_back(corners_.size());
    polygon_cells_.push_back(complex.cells_of_facet(f));
  }
  for (std::size_t c = 0; c < complex.cell_count(); ++c) {
    const std::span<const std::uint32_t> cell = complex.cell(c);
    cell_vertices_.insert(cell_vertices_.end(), cell.begin(), cell.end());
    cell_begin_.push_back(cell_vertices_.size());
  }
}

void DeloneFaces::take_plane(const DeloneComplex& complex) {
  std::vector<std::vector<std::array<std::uint32_t, 2>>> sides(complex.cell_count());
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    for (const std::uint32_t c : complex.cells_of_facet(f)) {
      if (c != outside) sides[c].push_back({complex.facet(f)[0], complex.facet(f)[1]});
    }
  }
  for (std::vector<std::array<std::uint32_t, 2>>& open : sides) {
    const std::uint32_t first = open.back()[0];
    for (std::uint32_t at = first; !open.empty();) {
      corners_.push_back(at);
      const auto next =
          std::find_if(open.begin(), open.end(), [&](const auto& side) { return side[0] == at || side[1] == at; });
      at = (*next)[0] == at ? (*next)[1] : (*next)[0];
      open.erase(next);
    }
    polygon_begin_.push_back(corners_.size());
    polygon_cells_.push_back({outside, outside});
  }
}

void DeloneFaces::find_sides(const Context& context) {
  for (std::uint32_t f = 0; f < polygon_cells_.size(); ++f) {
    if (f % 1024 == 0) context.poll();
    const std::span<const std::uint32_t> corners = polygon(f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t p = corners[i];
      const std::uint32_t q = corners[(i + 1) % corners.size()];
      const std::array<std::uint32_t, 2> edge{std::min(p, q), std::max(p, q)};
      sides_.push_back(
          static_cast<std::uint32_t>(std::lower_bound(edges_.begin(), edges_.end(), edge) - edges_.begin()));
    }
  }
}

void DeloneFaces::find_incidences() {
  const auto polygons = static_cast<std::uint32_t>(polygon_cells_.size());
  group(edges_.size(), ring_begin_, ring_, [&](const auto& add) {
    for (std::uint32_t f = 0; f < polygons; ++f) {
      for (std::size_t i = 0; i < sides(f).size(); ++i)
        add(sides(f)[i], RingPolygon{f, apex(f, i), static_cast<std::uint32_t>(i)});
    }
  });
  group(cell_begin_.size() - 1, cell_polygons_begin_, cell_polygons_, [&](const auto& add) {
    for (std::uint32_t f = 0; f < polygons; ++f) {
      for (const std::uint32_t c : polygon_cells_[f]) {
        if (c != outside) add(c, f);
      }
    }
  });
  group(vertices_.size(), vertex_edges_begin_, vertex_edges_, [&](const auto& add) {
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      for (const std::uint32_t v : edges_[e]) add(v, e);
    }
  });
}

std::size_t DeloneFaces::count(unsigned dimension) const {
  switch (dimension) {
    case 0:
      return vertices_.size();
    case 1:
      return edges_.size();
    case 2:
      return polygon_cells_.size();
    default:
      return cell_begin_.size() - 1;
  }
}

std::span<const std::uint32_t> DeloneFaces::vertices(DeloneFace face) const {
  switch (face.dimension) {
    case 0:
      return {vertices_.data() + face.index, 1};
    case 1:
      return edges_[face.index];
    case 2:
      return polygon(face.index);
    default:
      return cell(face.index);
  }
}

std::size_t DeloneFaces::side_of(std::uint32_t f, std::uint32_t edge) const {
  const std::span<const std::uint32_t> list = sides(f);
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), edge) - list.begin());
}

std::uint32_t DeloneFaces::apex(std::uint32_t f, std::size_t side) const {
  const std::span<const std::uint32_t> corners = polygon(f);
  return corners[(side + 2) % corners.size()];
}

std::array<std::uint32_t, 2> DeloneFaces::polygons_at_edge(std::uint32_t cell, std::uint32_t edge) const {
  std::array<std::uint32_t, 2> found{};
  std::size_t count = 0;
  for (const RingPolygon& at : ring(edge)) {
    const std::array<std::uint32_t, 2>& cells = polygon_cells_[at.polygon];
    if ((cells[0] == cell || cells[1] == cell) && count < 2) found[count++] = at.polygon;
  }
  return found;
}

std::uint32_t DeloneFaces::common_cell(std::uint32_t f, std::uint32_t g) const {
  for (const std::uint32_t c : polygon_cells_[f]) {
    if (c != outside && (polygon_cells_[g][0] == c || polygon_cells_[g][1] == c)) return c;
  }
  return outside;
}

}  // namespace quoin
