// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/cli/page_values.h"
#include "quoin/triangulation/delaunay3.h"
#include "quoin/view/layered_scene.h"

namespace quoin::cli {

// What pages of the flow have in common, of space and of a plane.

/// Of critical points by index, as the diagram has the classes that they begin.
inline constexpr std::array<Color, 4> color_of_index{Color{47, 111, 181, 255}, Color{200, 69, 92, 255},
                                                     Color{43, 145, 96, 255}, Color{138, 91, 181, 255}};
inline constexpr Color stable_edge_color{214, 130, 145, 255};
inline constexpr Color stable_surface_color{120, 186, 150, 120};
inline constexpr Color way_color{166, 132, 198, 255};

// More than these are hidden when the page is opened.
inline constexpr std::size_t most_critical_at_first = 3000;  ///< of an index; more hide what they stand on
inline constexpr std::size_t most_maxima_at_first = 300'000;
inline constexpr std::size_t most_on_surfaces = 12'000;  ///< points, edges, maxima
inline constexpr std::size_t most_edges_at_first = 200'000;
inline constexpr std::size_t most_ways_at_first = 4000;

/// Of each vertex, the first input point there.
std::vector<std::uint32_t> first_inputs(const Delaunay3& triangulation);

/// Says from where on elements of a layer are missing, and takes those away that begin then, of which there may be
/// some. Its elements have owners and come by ascending stops.
void cut_layer(SceneLayer& layer, std::uint32_t stop, const PageValues& stops, LayeredScene& scene);

}  // namespace quoin::cli
