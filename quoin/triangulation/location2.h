// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "quoin/base/sign.h"
#include "quoin/triangulation/triangulation_view2.h"

namespace quoin {

/// Where a point lies in a triangulation of the plane.
struct Location2 {
  enum class Place { vertex, edge, triangle, outside };

  Place place = Place::outside;
  Vertex2 vertex;      ///< at this one
  Edge2 edge;          ///< inside this one; outside: beyond this edge of the hull, which the infinite triangle owns
  Triangle2 triangle;  ///< inside this finite one
  std::size_t on_line = 0;  ///< in dimension 1, inside the edge between line()[on_line] and the next
};

/// The face that holds the query in its relative interior, exactly. Walks from the vertex `near`, or, without it or
/// where that takes more than `most_steps_from_hint` steps (delaunay_walks.h), from the nearest of a few samples:
/// O(n^(1/3)) expected for points spread evenly. Source: Mücke, Saias and Zhu 1999; the walk ends by the acyclicity
/// theorem of Edelsbrunner 1990, of regular triangulations, too.
/// @throws InputError  the query is not finite
Location2 locate(const TriangulationView2& triangulation, const Point2& query, Vertex2 near = Vertex2());

/// A vertex at the least distance of the query, with weights of the least power |query - v|^2 - weight; none of no
/// points; of several, the smallest id. Exact: from the corner of where the query lies, to nearer neighbours while
/// there are any (there are, until none is nearer at all).
/// @throws InputError  the query is not finite
Vertex2 nearest_vertex(const TriangulationView2& triangulation, const Point2& query, Vertex2 near = Vertex2());

/// Sign of |q - a| - |q - b|. Exact for all finite doubles: filter, then integers on the grid of the call. Zero if and
/// only if q lies on the bisector. O(1), allocates only for coordinates that span more than 124 bits.
Sign compare_distances(const Point2& q, const Point2& a, const Point2& b);

/// Sign of (|q - a|^2 - weight of a) - (|q - b|^2 - weight of b), of power distances. Exact for all finite doubles:
/// filter, then integers. Equal weights compare distances.
Sign compare_powers(const Point2& q, const WeightedPoint2& a, const WeightedPoint2& b);

}  // namespace quoin
