// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/triangulated_points.h"

#include <algorithm>

#include "quoin/base/error.h"
#include "quoin/cli/delone_faces.h"
#include "quoin/cli/point_input.h"
#include "quoin/cli/point_origins.h"
#include "quoin/triangulation/check2.h"
#include "quoin/triangulation/check3.h"
#include "quoin/triangulation/delone.h"
#include "quoin/triangulation/delone2.h"
#include "quoin/triangulation/regular2.h"
#include "quoin/triangulation/regular3.h"

namespace quoin::cli {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFF;
constexpr std::size_t poll_step = 4096;

void require_proof(const std::string& defect) {
  if (!defect.empty()) throw InternalError("the check of the triangulation failed: " + defect);
}

/// Collects the vertices; those that are none are left out.
class Vertices {
 public:
  Vertices(TriangulatedPoints& result, bool is_written) : result_(result), is_written_(is_written) {}

  /// Of the points at a vertex, the first ones.
  void add(std::span<const std::uint32_t> inputs) {
    ++result_.vertices;
    result_.largest_multiplicity = std::max(result_.largest_multiplicity, inputs.size());
    if (!is_written_) return;
    result_.first_input.push_back(inputs[0]);
    result_.multiplicity.push_back(static_cast<std::uint32_t>(inputs.size()));
  }

 private:
  TriangulatedPoints& result_;
  bool is_written_;
};

/// Delaunay2 and Regular2.
template <class Triangulation>
TriangulatedPoints take_plane(const Triangulation& t, const Delone2& delone, bool is_written, const Context& context) {
  TriangulatedPoints result;
  result.dimension = t.dimension();
  Vertices vertices(result, is_written);
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
    if (v % poll_step == 0) context.poll();
    vertices.add(t.inputs(Vertex2(v)));
  }
  const auto add_cell = [&](const std::array<std::uint32_t, 4>& cell, std::uint32_t label) {
    ++result.cells;
    if (!is_written) return;
    result.simplices.push_back(cell);
    result.delone_of.push_back(label);
  };
  if (t.dimension() < 2) {
    const std::span<const Vertex2> line = t.line();
    std::uint32_t label = 0;
    for (std::uint32_t i = 1; i < line.size(); ++i) {
      add_cell({line[i - 1].value, line[i].value, none, none}, label);
      if (delone.is_corner(line[i])) ++label;  // of weighted points ties are inside the edges
    }
    if (line.size() == 1) add_cell({line[0].value, none, none, none}, label++);
    result.delone = label;
    result.hull_vertices = std::min<std::size_t>(line.size(), 2);
    result.hull_simplices = result.hull_vertices;
    return result;
  }
  const Triangulation2& links = t.links();
  for (std::uint32_t i = 0; i < links.triangle_count(); ++i) {
    if (i % poll_step == 0) context.poll();
    if (links.is_infinite(Triangle2(i))) {
      ++result.hull_simplices;
      continue;
    }
    const std::array<Vertex2, 3> v = links.corners(Triangle2(i));
    add_cell({v[0].value, v[1].value, v[2].value, none}, delone.cell(Triangle2(i)).value);
  }
  result.hull_vertices = result.hull_simplices;
  result.delone = delone.cell_count();
  return result;
}

/// Delaunay3 and Regular3. `number` has for each vertex its number among those that are not hidden.
template <class Triangulation>
TriangulatedPoints take_space(const Triangulation& t, const std::vector<std::uint32_t>& number,
                              const DeloneLabels& labels, bool is_written, const Context& context) {
  TriangulatedPoints result;
  result.dimension = t.dimension();
  const auto size = static_cast<std::size_t>(t.dimension()) + 1;
  std::vector<bool> is_on_hull(t.vertex_count());
  for (std::size_t c = 0; c < t.cells().size(); ++c) {
    if (c % poll_step == 0) context.poll();
    std::array<std::uint32_t, 4> vertices = t.cells()[c].vertices;
    const bool is_ghost = t.is_ghost(c);
    for (std::size_t i = 0; i + (is_ghost ? 1 : 0) < size; ++i) {
      if (is_ghost) is_on_hull[vertices[i]] = true;
      if (!number.empty()) vertices[i] = number[vertices[i]];
    }
    if (is_ghost) {
      ++result.hull_simplices;
      if (is_written && t.dimension() == 3) result.hull.push_back({vertices[0], vertices[1], vertices[2]});
      continue;
    }
    ++result.cells;
    if (!is_written) continue;
    result.simplices.push_back(vertices);
    result.delone_of.push_back(labels.cell_of[c]);
  }
  result.hull_vertices = static_cast<std::size_t>(std::ranges::count(is_on_hull, true));
  if (t.dimension() == 0) result.hull_vertices = 1;
  if (t.dimension() < 2) result.hull_simplices = result.hull_vertices;
  result.delone = labels.cell_count;
  return result;
}

TriangulatedPoints triangulate_plane(const PointFile& file, const TriangulateOptions& options, const Context& context) {
  const std::vector<Point2> points = plane_points(file);
  const Delaunay2 t(points, {}, context);
  context.progress("Delone cells", 0);
  const Delone2 delone(t, context);
  if (options.check) {
    context.progress("check", 0);
    require_proof(defect(t, points, context));
  }
  TriangulatedPoints result = take_plane(t, delone, options.is_written, context);
  if (options.delone) result.delone_faces = delone_faces(t, delone, context);
  result.distinct = result.vertices;
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
    const std::span<const std::uint32_t> inputs = t.inputs(Vertex2(v));
    for (const std::uint32_t i : inputs) result.heights_lost += file.points[i].z != file.points[inputs[0]].z ? 1 : 0;
  }
  return result;
}

TriangulatedPoints triangulate_weighted_plane(const PointFile& file, const TriangulateOptions& options,
                                              const Context& context) {
  const Regular2 t(weighted_plane_points(file), context);
  context.progress("Delone cells", 0);
  TriangulatedPoints result = take_plane(t, Delone2(t, context), options.is_written, context);
  result.hidden = t.hidden().size();
  result.distinct = distinct_places(file);
  return result;
}

TriangulatedPoints triangulate_space(const PointFile& file, const TriangulateOptions& options, const Context& context) {
  const Delaunay3 t(file.points, context);
  context.progress("Delone cells", 0);
  const DeloneLabels labels = delone_labels(t, context);
  if (options.check) {
    context.progress("check", 0);
    require_proof(defect(t, file.points, context));
  }
  TriangulatedPoints result = take_space(t, {}, labels, options.is_written, context);
  if (options.delone) result.delone_faces = delone_faces(t, context);
  Vertices vertices(result, options.is_written);
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
    if (v % poll_step == 0) context.poll();
    vertices.add(t.inputs(v));
  }
  result.distinct = result.vertices;
  return result;
}

TriangulatedPoints triangulate_weighted_space(const PointFile& file, const TriangulateOptions& options,
                                              const Context& context) {
  const Regular3 t(file.points, file.weights, context);
  std::vector<std::uint32_t> number(t.vertex_count(), none);
  std::vector<std::vector<std::uint32_t>> inputs;  // of vertices, those of their weight
  std::size_t seen = 0;
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
    if (v % poll_step == 0) context.poll();
    if (t.is_hidden(v)) continue;
    number[v] = static_cast<std::uint32_t>(inputs.size());
    inputs.emplace_back();
    for (const std::uint32_t i : t.inputs(v)) {
      if (file.weights[i] == t.weight(v)) inputs.back().push_back(i);
    }
    seen += inputs.back().size();
  }
  context.progress("Delone cells", 0);
  TriangulatedPoints result = take_space(t, number, delone_labels(t, context), options.is_written, context);
  Vertices vertices(result, options.is_written);
  for (const std::vector<std::uint32_t>& list : inputs) vertices.add(list);
  result.distinct = t.vertex_count();
  result.hidden = file.points.size() - seen;
  return result;
}

}  // namespace

TriangulatedPoints triangulate(const PointFile& file, const TriangulateOptions& options, const Context& context) {
  const bool weighted = !file.weights.empty();
  if (options.of_plane) {
    return weighted ? triangulate_weighted_plane(file, options, context) : triangulate_plane(file, options, context);
  }
  return weighted ? triangulate_weighted_space(file, options, context) : triangulate_space(file, options, context);
}

std::uint64_t memory_to_triangulate(std::size_t points, const TriangulateOptions& options, bool weighted) {
  // Measured at a million points, what the file says of them included.
  std::uint64_t per_point = options.of_plane ? 260 : 320;
  if (weighted) per_point += 100;
  if (options.check) per_point += options.of_plane ? 10 : 30;
  if (options.is_written) per_point += options.of_plane ? 130 : 850;
  if (options.delone) per_point += options.of_plane ? 200 : 2100;
  return points * per_point;
}

VtkGrid grid_of(const TriangulatedPoints& triangulated, const PointFile& file) {
  VtkGrid grid;
  static constexpr std::array<VtkCell, 4> types{VtkCell::vertex, VtkCell::line, VtkCell::triangle,
                                                VtkCell::tetrahedron};
  const auto dimension = static_cast<std::size_t>(triangulated.dimension);
  for (const std::uint32_t i : triangulated.first_input) grid.points.push_back(file.points[i]);
  const bool has_simplices = triangulated.delone_faces.cell_count() == 0;
  if (has_simplices) {
    for (const auto& simplex : triangulated.simplices) grid.add_cell(types[dimension], {simplex.data(), dimension + 1});
  } else {
    add_to_grid(triangulated.delone_faces, grid);
  }
  grid.point_integers.emplace_back("input", triangulated.first_input);
  grid.point_integers.emplace_back("multiplicity", triangulated.multiplicity);
  add_data(grid, data_of(file, triangulated.first_input));
  if (has_simplices && !triangulated.delone_of.empty())
    grid.cell_integers.emplace_back("delone_cell", triangulated.delone_of);
  return grid;
}

CellMesh mesh_of(const TriangulatedPoints& triangulated, const PointFile& file) {
  CellMesh made;
  Mesh& mesh = made.mesh;
  std::vector<std::uint32_t> number(triangulated.first_input.size(), none);
  const auto add = [&](std::uint32_t vertex) {
    number[vertex] = static_cast<std::uint32_t>(mesh.vertices.size());
    made.add_vertex(file, triangulated.first_input[vertex]);
  };
  const auto add_face = [&](std::span<const std::uint32_t> vertices) {
    for (const std::uint32_t v : vertices) {
      if (number[v] == none) add(v);
      mesh.corners.push_back(number[v]);
    }
    mesh.face_begin.push_back(mesh.corners.size());
  };
  if (triangulated.dimension < 3) {
    for (std::uint32_t v = 0; v < number.size(); ++v) add(v);
  }
  if (triangulated.delone_faces.cell_count() > 0) {
    for_each_outer_polygon(triangulated.delone_faces, add_face);
    return made;
  }
  for (const auto& triangle : triangulated.hull) add_face(triangle);
  if (triangulated.dimension == 2) {
    for (const auto& simplex : triangulated.simplices) add_face(std::span(simplex).first(3));
  }
  return made;
}

}  // namespace quoin::cli
