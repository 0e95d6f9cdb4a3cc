// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/flow/delone_faces.h"
#include "quoin/flow/face_signs.h"
#include "quoin/kernel/rational_point.h"

namespace quoin {

/// What a Delone face means for the flow.
enum class FlowKind : std::uint8_t {
  passing,   ///< orbits go on from all points of its dual
  regular,   ///< its centre is on its dual and stops orbits, but is on its own boundary: no critical point
  critical,  ///< its centre is on its dual and in its interior: critical, of the face's dimension as index
};

/// The flow of the distance to points of space: points move away from the nearest point of the convex hull of their
/// nearest input points. Critical points, and where orbits go from each open face of the Voronoi diagram.
///
/// Exact for all finite doubles in any position. Faces are those of the Delone complex, so nothing depends on how
/// cospherical points are triangulated. A point is critical if it is in the relative interior of the hull of its
/// nearest input points, so the numbers of critical points have the alternating sum 1. Equal points are one. Source:
/// Cazals, Parameswaran, Pion, Robust construction of the three-dimensional flow complex, 2008 (definition 1 and
/// section 3); Giesen and John 2003. Departs from them: tables are of Delone faces, without duplicate vertices.
class FlowComplex {
 public:
  /// O(n log n) for n faces. The triangulation is not needed afterwards. @throws Cancelled
  FlowComplex(const Delaunay3& triangulation, const Context& context);

  const DeloneFaces& faces() const { return faces_; }
  const FaceSigns& signs() const { return signs_; }
  /// Of a vertex of the triangulation.
  const Point3& point(std::uint32_t vertex) const { return points_[vertex]; }

  FlowKind kind(DeloneFace face) const;
  bool is_critical(DeloneFace face) const { return kind(face) == FlowKind::critical; }
  /// Whether orbits stop at the centre of the face.
  bool is_stationary(DeloneFace face) const { return kind(face) != FlowKind::passing; }

  /// The face in whose dual orbits go on from points of the dual of this one. They move away from its centre; the face
  /// itself if they stay in the dual until they leave it.
  DeloneFace crossed(DeloneFace face) const;
  /// Sides of a polygon, or edges of a cell, from whose duals orbits enter the dual of the face.
  std::vector<std::uint32_t> entering_edges(DeloneFace face) const;
  /// Whether orbits enter a Voronoi vertex along Voronoi edges.
  bool has_entering_polygon(std::uint32_t cell) const;

  /// Centre of the smallest sphere through the vertices of the face. Exact.
  RationalPoint3 centre(DeloneFace face) const;
  /// Its squared radius; of a critical face the squared value of the distance there.
  Rational square_radius(DeloneFace face) const;

  /// Faces of a kind by ascending dimension and number.
  std::vector<DeloneFace> faces_of_kind(FlowKind kind) const;
  /// Critical points by index.
  std::array<std::size_t, 4> counts() const;

 private:
  std::array<Point3, 3> circle(std::uint32_t polygon) const;
  void classify_edges();
  void classify_polygons();
  void classify_cells(const Context& context);
  std::uint32_t edge_that_separates(std::uint32_t cell) const;

  DeloneFaces faces_;
  std::vector<Point3> points_;
  FaceSigns signs_;
  std::array<std::vector<FlowKind>, 4> kinds_;
  std::vector<DeloneFace> crossed_by_polygons_;
  std::vector<DeloneFace> crossed_by_cells_;
};

}  // namespace quoin
