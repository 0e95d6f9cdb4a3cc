// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/exact_outputs.h"

#include <utility>

#include "quoin/cli/point_origins.h"
#include "quoin/kernel/rational_point.h"

namespace quoin::cli {

namespace {

constexpr std::size_t poll_step = 4096;

/// Without cells.
ExactCells vertices_of(const PointFile& file, const std::vector<std::uint32_t>& first_input,
                       const std::vector<std::uint32_t>& multiplicity) {
  ExactCells cells;
  cells.dimension = static_cast<unsigned>(file.dimension);
  for (const std::uint32_t i : first_input) cells.add_point(file.points[i]);
  ExactColumns& columns = cells.point_data;
  columns.integers = {{"input", first_input}, {"multiplicity", multiplicity}};
  add_data(columns, data_of(file, first_input));
  return cells;
}

}  // namespace

ExactCells exact_cells_of(const TriangulatedPoints& triangulated, const PointFile& file) {
  ExactCells cells = vertices_of(file, triangulated.first_input, triangulated.multiplicity);
  const ExactCells& faces = triangulated.delone_faces;
  for (std::size_t c = 0; c < faces.cell_count(); ++c) cells.add_cell(faces.kinds[c], faces.cell(c));
  if (faces.cell_count() > 0) return cells;
  const auto size = static_cast<std::size_t>(triangulated.dimension) + 1;
  for (const auto& simplex : triangulated.simplices) cells.add_cell(ExactCellKind::simplex, {simplex.data(), size});
  if (!triangulated.delone_of.empty()) cells.cell_data.integers.emplace_back("delone_cell", triangulated.delone_of);
  return cells;
}

ExactCells exact_cells_of_shape(const AlphaPoints& points, std::uint32_t grades, const PointFile& file,
                                const Context& context) {
  const AlphaComplex& alpha = points.alpha;
  ExactCells cells = vertices_of(file, points.first_input, points.multiplicity);
  ExactNumbers values;
  Rational value;
  std::uint32_t last = ExactColumns::none;
  for (const SimplexId s : alpha.order(context)) {
    if (cells.cell_count() % poll_step == 0) context.poll();
    const std::uint32_t grade = alpha.grade_of(s);
    if (grade >= grades) break;
    if (grade != last) value = alpha.exact_value(grade);
    last = grade;
    cells.add_cell(ExactCellKind::simplex, alpha.complex().vertices(s));
    values.add(value);
  }
  cells.cell_data.numbers.emplace_back("value", std::move(values));
  return cells;
}

ExactCells exact_cells_of_graph(const AlphaPoints& points, const VertexPairs& edges, const PointFile& file) {
  ExactCells cells = vertices_of(file, points.first_input, points.multiplicity);
  ExactNumbers squares;
  for (const auto& edge : edges) {
    cells.add_cell(ExactCellKind::simplex, edge);
    const RationalPoint3 between =
        exact_point(points.alpha.spheres().point(edge[1])) - exact_point(points.alpha.spheres().point(edge[0]));
    squares.add(dot(between, between));
  }
  cells.cell_data.numbers.emplace_back("square_length", std::move(squares));
  return cells;
}

}  // namespace quoin::cli
