// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "quoin/kernel/constructions.h"
#include "quoin/solid/mesh.h"

namespace quoin {

/// A face of an input mesh.
struct Origin {
  std::uint32_t leaf;  ///< index of the input solid
  std::uint32_t face;  ///< index of its mesh face
  friend auto operator<=>(const Origin&, const Origin&) = default;
};

/// A connected part of a boundary: faces joined through edges, where around an edge the two faces that enclose material
/// between them are joined.
struct Shell {
  bool is_void;  ///< bounds material from inside (a cavity)
};

/// Boundary of a solid: maximal planar faces with holes over exact vertices.
///
/// A vertex is a point of `points` that some loop names; other explicit points only span planes. Loops are closed
/// chains of vertices with the face on their left seen from outside: outer loops counterclockwise, holes clockwise. A
/// face may have several outer loops only by touching itself in vertices; a loop may pass a vertex twice, and an edge
/// in both directions: a slit, where other faces touch this one along an edge (two vertices are a loop then). A loop of
/// one vertex is where other faces touch this one from one side in a point inside it; behind the other loops. Every
/// edge is used as often in one direction as in the other; more than once each is a nonmanifold edge.
struct Brep {
  Constructions points{std::vector<Point3>{}};
  std::vector<std::array<PointId, 3>> face_planes;  ///< explicit points; outward normal (b - a) x (c - a)
  std::vector<std::uint32_t> face_first_loop{0};    ///< face_count() + 1 offsets into loop_begin
  std::vector<std::uint32_t> loop_begin{0};         ///< loop count + 1 offsets into loop_vertices
  std::vector<PointId> loop_vertices;
  std::vector<std::uint32_t> face_first_origin{0};  ///< face_count() + 1 offsets into origins
  std::vector<Origin> origins;             ///< the input faces a face lies on, ascending; at least one per face
  std::vector<std::uint32_t> face_shells;  ///< index into shells
  std::vector<Shell> shells;
  std::uint32_t component_count = 0;    ///< connected pieces of material
  bool is_unbounded = false;            ///< the solid contains all points far away (complements)
  std::vector<Color> face_colors;       ///< empty, or per face
  std::vector<std::string> leaf_names;  ///< by Origin::leaf

  std::size_t face_count() const { return face_planes.size(); }
  std::size_t loop_count() const { return loop_begin.size() - 1; }
  std::span<const PointId> loop(std::size_t index) const {
    return {loop_vertices.data() + loop_begin[index], loop_begin[index + 1] - loop_begin[index]};
  }
};

}  // namespace quoin
