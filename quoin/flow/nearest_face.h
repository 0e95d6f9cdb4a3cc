// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "quoin/flow/flow_complex.h"

namespace quoin {

/// The face of the vertices that are nearest to a point: the point is in its dual. Walks over edges, each to a nearer
/// vertex. Exact; O(n) for n edges at worst.
DeloneFace nearest_face(const FlowComplex& flow, const RationalPoint3& place);

/// The face whose dual has the points that are on the Voronoi facets of just these edges of a vertex, among its own.
DeloneFace face_of_edges(const DeloneFaces& faces, std::uint32_t vertex, std::span<const std::uint32_t> edges);

}  // namespace quoin
