// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/io/point_file.h"
#include "quoin/triangulation/alpha_complex.h"

namespace quoin::cli {

/// The alpha complex of the points of a file, and which of them its vertices are.
struct AlphaPoints {
  AlphaComplex alpha;
  std::vector<std::uint32_t> first_input{};   ///< by vertex of the complex
  std::vector<std::uint32_t> multiplicity{};  ///< by vertex
  std::size_t distinct = 0;                   ///< places with points
  std::size_t hidden = 0;                     ///< points that are no vertices, for their weights
  std::size_t heights_lost = 0;               ///< points at a vertex of the plane with another z than its first
};

/// Of Delaunay2, Delaunay3, Regular2 or Regular3.
/// @throws InputError  the complex needs more memory than options.memory, or else than is free; and what those throw
AlphaPoints alpha_of_points(const PointFile& file, const Options& options, const Context& context);

}  // namespace quoin::cli
