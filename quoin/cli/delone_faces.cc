// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/delone_faces.h"

#include <algorithm>
#include <array>

#include "quoin/triangulation/delone.h"

namespace quoin::cli {

namespace {

constexpr std::size_t poll_step = 1024;
using Pair = std::array<std::uint32_t, 2>;

/// The corners of a polygon in order, from its sides in any order. Each corner has two of these.
std::vector<std::uint32_t> loop_of(std::vector<Pair>& sides) {
  const std::size_t count = sides.size();
  for (std::size_t i = 0; i < count; ++i) sides.push_back({sides[i][1], sides[i][0]});
  std::ranges::sort(sides);
  std::vector<std::uint32_t> loop{sides[0][0], sides[0][1]};
  while (loop.size() < count) {
    const auto first = std::ranges::lower_bound(sides, Pair{loop.back(), 0});
    const std::uint32_t before = loop[loop.size() - 2];
    loop.push_back((*first)[1] == before ? (*std::next(first))[1] : (*first)[1]);
  }
  return loop;
}

/// For each cell what `part(facet, side)` makes of its facets.
template <class T, class Part>
std::vector<std::vector<T>> facets_of_cells(const DeloneComplex& complex, const Context& context, const Part& part) {
  std::vector<std::vector<T>> facets(complex.cell_count());
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    if (f % poll_step == 0) context.poll();
    const std::array<std::uint32_t, 2> cells = complex.cells_of_facet(f);
    for (unsigned side = 0; side < 2; ++side) {
      if (cells[side] != DeloneComplex::outside) facets[cells[side]].push_back(part(f, side));
    }
  }
  return facets;
}

}  // namespace

ExactCells delone_faces(const Delaunay3& triangulation, const Context& context) {
  const DeloneComplex complex(triangulation, context);
  ExactCells faces;
  if (complex.dimension() < 2) {
    for (std::size_t c = 0; c < complex.cell_count(); ++c) faces.add_cell(ExactCellKind::simplex, complex.cell(c));
  } else if (complex.dimension() == 2) {
    const auto side = [&](std::uint32_t f, unsigned) { return Pair{complex.facet(f)[0], complex.facet(f)[1]}; };
    for (std::vector<Pair>& sides : facets_of_cells<Pair>(complex, context, side))
      faces.add_cell(ExactCellKind::polygon, loop_of(sides));
  } else {
    for (std::size_t f = 0; f < complex.facet_count(); ++f) faces.add_cell(ExactCellKind::polygon, complex.facet(f));
    const auto part = [](std::uint32_t f, unsigned side) { return ExactCells::part_of(f, side == 1); };
    for (const std::vector<std::uint32_t>& parts : facets_of_cells<std::uint32_t>(complex, context, part))
      faces.add_cell(ExactCellKind::polyhedron, parts);
  }
  return faces;
}

ExactCells delone_faces(const Delaunay2& triangulation, const Delone2& delone, const Context& context) {
  ExactCells faces;
  faces.dimension = 2;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t c = 0; c < delone.cell_count(); ++c) {
    if (c % poll_step == 0) context.poll();
    corners.clear();
    for (const Vertex2 v : delone.corners(DeloneCell2(c))) corners.push_back(v.value);
    faces.add_cell(ExactCellKind::polygon, corners);
  }
  if (triangulation.dimension() >= 2) return faces;
  const std::span<const Vertex2> line = triangulation.line();
  if (line.size() == 1) faces.add_cell(ExactCellKind::simplex, std::array{line[0].value});
  for (std::size_t i = 1; i < line.size(); ++i)
    faces.add_cell(ExactCellKind::simplex, std::array{line[i - 1].value, line[i].value});
  return faces;
}

void add_to_grid(const ExactCells& faces, VtkGrid& grid) {
  const bool has_polyhedra = std::ranges::count(faces.kinds, ExactCellKind::polyhedron) > 0;
  std::vector<std::uint32_t> numbers;
  for (std::size_t c = 0; c < faces.cell_count(); ++c) {
    const std::span<const std::uint32_t> parts = faces.cell(c);
    if (faces.kinds[c] == ExactCellKind::simplex) {
      grid.add_cell(parts.size() == 1 ? VtkCell::vertex : VtkCell::line, parts);
    } else if (faces.kinds[c] == ExactCellKind::polyhedron) {
      numbers.assign(1, static_cast<std::uint32_t>(parts.size()));
      for (const std::uint32_t part : parts) {
        const std::span<const std::uint32_t> corners = faces.cell(ExactCells::face_of(part));
        numbers.push_back(static_cast<std::uint32_t>(corners.size()));
        const auto first = numbers.insert(numbers.end(), corners.begin(), corners.end());
        if (ExactCells::is_turned(part)) std::reverse(first, numbers.end());
      }
      grid.add_cell(VtkCell::polyhedron, numbers);
    } else if (!has_polyhedra) {
      grid.add_cell(VtkCell::polygon, parts);
    }
  }
}

}  // namespace quoin::cli
