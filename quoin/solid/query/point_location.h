// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/box_tree.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/placed_point.h"

namespace quoin {

/// Where a point lies with respect to a solid.
enum class Place : std::uint8_t { out, in, on_face, on_edge, on_vertex };

constexpr bool is_on_boundary(Place place) {
  return place >= Place::on_face;
}

/// A place with the element of the boundary that the point lies on.
struct SolidLocation {
  Place place = Place::out;
  std::uint32_t face = no_face;  ///< the face, or the first of those about the edge or vertex
  PointId a;                     ///< the vertex, or an end of the edge
  PointId b;                     ///< the other end of the edge

  static constexpr std::uint32_t no_face = 0xFFFFFFFFU;
  friend bool operator==(const SolidLocation&, const SolidLocation&) = default;
};

/// Answers where points lie with respect to one boundary. Immutable after construction; safe to share between threads.
///
/// Exact for any rational point. Boundary points are recognised as such; others are inside when a line from them
/// crosses an odd number of faces (an even number for unbounded solids), the line moved by an infinitesimal so that it
/// meets no edge.
class SolidLocator {
 public:
  /// O(n log n). The boundary must outlive the locator.
  SolidLocator(const Brep& boundary, const Context& context);

  /// O(log n + c) for c corners of faces near the point or near the line through it along z.
  SolidLocation locate(const RationalPoint3& point) const;
  SolidLocation locate(const Point3& point) const;

  const Brep& boundary() const { return boundary_; }
  /// The tree of the faces' boxes.
  const BoxTree& tree() const { return tree_; }

 private:
  SolidLocation on_boundary(const PlacedPoint& point) const;
  bool is_inside(const PlacedPoint& point) const;

  const Brep& boundary_;
  BoxTree tree_;
};

/// The conservative box of a face.
FloatBox box_of_face(const Brep& boundary, std::uint32_t face);

/// All of `points`, on all threads.
std::vector<SolidLocation> locate_all(const SolidLocator& locator, std::span<const Point3> points,
                                      const Context& context);

}  // namespace quoin
