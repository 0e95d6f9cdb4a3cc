// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/alpha_points.h"

#include <algorithm>
#include <span>

#include "quoin/cli/cell_outputs.h"
#include "quoin/cli/memory.h"
#include "quoin/cli/point_input.h"
#include "quoin/cli/targets.h"
#include "quoin/triangulation/delaunay2.h"
#include "quoin/triangulation/delaunay3.h"
#include "quoin/triangulation/regular2.h"
#include "quoin/triangulation/regular3.h"

namespace quoin::cli {

namespace {

constexpr std::size_t poll_step = 4096;
constexpr std::size_t cells_of_full_layers = 1'000'000;

/// Of a complex of so many simplices of full dimension, with what the command takes and writes. Measured on a million
/// points in a cube; exact values on fewer; pages, whose layers do not grow for ever, on a hundred thousand and more.
std::uint64_t memory_of_cells(std::size_t cells, int dimension, const Options& options) {
  std::uint64_t bytes = static_cast<std::uint64_t>(cells) * (dimension == 3 ? 330 : 260);
  if (writes(options, Target::Kind::cells)) bytes += static_cast<std::uint64_t>(cells) * (dimension == 3 ? 1500 : 900);
  const bool has_page = writes(options, Target::Kind::page);
  if (has_page && dimension == 3) bytes += 180 * std::min(cells, cells_of_full_layers) + 60 * cells;
  if (has_page && dimension != 3) bytes += 150 * cells;
  return bytes;
}

/// Reads vertices by what `inputs(label, list)` puts into a list: the points at a vertex, those of its weight.
template <class Triangulation, class Inputs>
AlphaPoints take(const Triangulation& triangulation, std::size_t cells, const PointFile& file, const Options& options,
                 const Inputs& inputs, const Context& context) {
  announce_memory(memory_of_cells(cells, triangulation.dimension(), options), file.points.size(), options);
  context.progress("alpha complex", 0);
  AlphaPoints result{.alpha = AlphaComplex(triangulation, context)};
  const SimplicialComplex& complex = result.alpha.complex();
  std::vector<std::uint32_t> list;
  std::size_t seen = 0;
  for (std::uint32_t v = 0; v < complex.count(0); ++v) {
    if (v % poll_step == 0) context.poll();
    list.clear();
    inputs(complex.label(v), list);
    seen += list.size();
    result.first_input.push_back(list[0]);
    result.multiplicity.push_back(static_cast<std::uint32_t>(list.size()));
    for (const std::uint32_t i : list) result.heights_lost += file.points[i].z != file.points[list[0]].z ? 1 : 0;
  }
  result.hidden = file.points.size() - seen;
  return result;
}

void append(std::vector<std::uint32_t>& list, std::span<const std::uint32_t> more) {
  list.insert(list.end(), more.begin(), more.end());
}

std::size_t triangles_of(std::size_t points) {
  return 2 * points;
}

AlphaPoints of_plane(const PointFile& file, const Options& options, const Context& context) {
  const std::vector<Point2> points = plane_points(file);
  const Delaunay2 t(points, {}, context);
  const auto inputs = [&](std::uint32_t v, std::vector<std::uint32_t>& list) { append(list, t.inputs(Vertex2(v))); };
  AlphaPoints result = take(t, triangles_of(t.vertex_count()), file, options, inputs, context);
  result.distinct = t.vertex_count();
  return result;
}

AlphaPoints of_weighted_plane(const PointFile& file, const Options& options, const Context& context) {
  const Regular2 t(weighted_plane_points(file), context);
  const auto inputs = [&](std::uint32_t v, std::vector<std::uint32_t>& list) { append(list, t.inputs(Vertex2(v))); };
  AlphaPoints result = take(t, triangles_of(t.vertex_count()), file, options, inputs, context);
  result.distinct = distinct_places(file);
  return result;
}

AlphaPoints of_space(const PointFile& file, const Options& options, const Context& context) {
  const Delaunay3 t(file.points, context);
  const auto inputs = [&](std::uint32_t v, std::vector<std::uint32_t>& list) { append(list, t.inputs(v)); };
  AlphaPoints result = take(t, t.cells().size(), file, options, inputs, context);
  result.distinct = t.vertex_count();
  return result;
}

AlphaPoints of_weighted_space(const PointFile& file, const Options& options, const Context& context) {
  const Regular3 t(file.points, file.weights, context);
  const auto inputs = [&](std::uint32_t v, std::vector<std::uint32_t>& list) {
    for (const std::uint32_t i : t.inputs(v)) {
      if (file.weights[i] == t.weight(v)) list.push_back(i);
    }
  };
  AlphaPoints result = take(t, t.cells().size(), file, options, inputs, context);
  result.distinct = t.vertex_count();
  return result;
}

}  // namespace

AlphaPoints alpha_of_points(const PointFile& file, const Options& options, const Context& context) {
  const bool is_weighted = !file.weights.empty();
  AlphaPoints result = is_of_plane(file, options)
                           ? (is_weighted ? of_weighted_plane : of_plane)(file, options, context)
                           : (is_weighted ? of_weighted_space : of_space)(file, options, context);
  if (!is_of_plane(file, options)) result.heights_lost = 0;
  return result;
}

}  // namespace quoin::cli
