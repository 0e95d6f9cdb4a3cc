// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/solid/brep.h"
#include "quoin/solid/placed_point.h"

namespace quoin {

/// Where a point lies with respect to a face, both projected along an axis.
struct FacePlace {
  enum class Kind : std::uint8_t { outside, inside, on_edge, on_vertex };
  Kind kind;
  PointId a;  ///< the vertex, or an end of the edge
  PointId b;  ///< the other end of the edge
  /// The point moved by (e, e^2) with an infinitesimal e is inside. Consistent over all faces that meet in an edge, so
  /// that a line through the moved point hits no edge.
  bool is_inside_when_moved;
};

/// An axis along which the face has a projection of nonzero area.
unsigned projection_axis(const Brep& boundary, std::uint32_t face);

/// Exact; even-odd over the loops. For a point on the face's plane and `axis` as above this is its place in the face;
/// along an axis parallel to the face, `is_inside_when_moved` is false. O(n) for n corners.
FacePlace place_in_face(const Brep& boundary, std::uint32_t face, const PlacedPoint& point, unsigned axis);

/// The side of the face's plane on which the point lies, positive outward.
Sign side_of_face(const Brep& boundary, std::uint32_t face, const PlacedPoint& point);

/// A point strictly inside the face.
RationalPoint3 interior_point(const Brep& boundary, std::uint32_t face);

}  // namespace quoin
