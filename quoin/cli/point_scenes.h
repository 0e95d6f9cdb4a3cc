// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "quoin/base/context.h"
#include "quoin/cli/alpha_points.h"
#include "quoin/cli/triangulated_points.h"
#include "quoin/triangulation/alpha_shape.h"
#include "quoin/triangulation/neighbour_graphs.h"
#include "quoin/view/layered_scene.h"

namespace quoin::cli {

/// A layer of a page of points holds no more triangles, and no more edges. All triangles of half a million points on a
/// surface that are there once it is closed are fewer.
inline constexpr std::size_t most_triangles_drawn = std::size_t{1} << 22;
inline constexpr std::size_t most_edges_drawn = std::size_t{1} << 20;

/// The scene with the points of a file that are vertices, with their numbers, and a layer of them with their colours.
LayeredScene scene_of_points(const PointFile& file, std::span<const std::uint32_t> first_input);

/// All alpha complexes of points by value: boundaries, singular triangles, edges, points; how many simplices there are,
/// Betti numbers, and the persistence diagram. `shown` is the number of grades of the complex that is shown first.
///
/// Where there are many values the page stops at some of them; what it shows at each is exact. Layers of
/// very many triangles or edges are drawn from some value on; a fact says so.
/// @throws Cancelled
LayeredScene scene_of_alpha(const AlphaPoints& points, const AlphaIntervals& intervals,
                            std::optional<std::uint32_t> shown, const PointFile& file, const Context& context);

/// The points, and edges between them.
LayeredScene scene_of_graph(const AlphaPoints& points, const VertexPairs& edges, const std::string& name,
                            const PointFile& file);

/// The points, edges, and triangles of the hull or of the plane. @throws Cancelled
LayeredScene scene_of_triangulation(const TriangulatedPoints& made, const PointFile& file, const Context& context);

}  // namespace quoin::cli
