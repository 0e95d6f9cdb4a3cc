// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/cell_outputs.h"
#include "quoin/triangulation/regions2.h"
#include "quoin/view/planar_picture.h"

namespace quoin::cli {

/// What rounding did to constructed points, of those that are written.
struct RoundedCrossings {
  std::size_t points = 0;            ///< that are no doubles
  double max_displacement = 0;       ///< of a coordinate, an upper bound
  std::size_t turned_triangles = 0;  ///< that are flat or inside out, by exact signs of the rounded corners
};

/// A constrained triangulation with its domains, and which part of it is written: all of it, or what is inside.
///
/// Domains are what segments divide the plane into, 0 what is outside of all; a triangle at an odd depth is inside. A
/// piece of a segment is of the domain on its less deep side.
class ConstrainedDomains {
 public:
  /// The triangulation must outlive it. @throws Cancelled
  ConstrainedDomains(const ConstrainedDelaunay2& triangulation, bool inside_only, const Context& context);

  std::size_t triangle_count() const { return triangle_count_; }  ///< finite ones
  std::size_t inside_count() const { return inside_count_; }
  /// Without domain 0.
  std::size_t domain_count() const { return regions_.count() - 1; }
  std::uint32_t largest_depth() const;
  /// Written triangles.
  std::size_t written_count() const { return triangles_.size(); }
  RoundedCrossings rounding(const Context& context) const;

  /// Triangles, then pieces as edges, over the vertices that are written; corners rounded to nearest.
  VtkGrid grid() const;
  /// The same, exact.
  ExactCells exact_cells(const Context& context) const;
  /// Triangles.
  Mesh mesh() const;
  /// Triangles by depth, edges, pieces of segments strong, points.
  PlanarPicture picture(bool has_labels) const;

 private:
  struct Place {
    std::uint32_t depth;
    std::uint32_t domain;
    friend auto operator<=>(const Place&, const Place&) = default;
  };
  struct WrittenPiece {
    std::size_t piece;
    Place place;
  };
  void choose(bool inside_only, const Context& context);
  bool is_inside(Triangle2 t) const { return regions_.depth(regions_.region(t)) % 2 == 1; }
  Place place_of(Triangle2 t) const { return {regions_.depth(regions_.region(t)), regions_.region(t)}; }
  bool is_constructed(Vertex2 v) const { return v.index() >= triangulation_.given_count(); }
  std::array<std::uint32_t, 3> corners(Triangle2 t) const;
  std::array<std::uint32_t, 2> ends(std::size_t piece) const;
  void add_faces(PlanarPicture& picture) const;
  void add_edges(PlanarPicture& picture) const;

  const ConstrainedDelaunay2& triangulation_;
  Regions2 regions_;
  std::size_t triangle_count_ = 0;
  std::size_t inside_count_ = 0;
  std::vector<Triangle2> triangles_;  // that are written
  std::vector<WrittenPiece> pieces_;
  std::vector<Vertex2> vertices_;
  std::vector<std::uint32_t> number_;  // of a vertex among those
};

}  // namespace quoin::cli
