// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "quoin/solid/check.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/query/point_location.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"
#include "quoin/solid/topology_counts.h"

/// Solids for tests of known answers, and what is expected of them.
namespace quoin::testing {

inline const Context one_thread({.threads = 1});

inline Solid solid(const Mesh& mesh) {
  const LeafResult result = make_leaf(mesh, {}, one_thread);
  if (!result.leaf) {
    ADD_FAILURE() << "a mesh of " << mesh.face_count() << " faces does not bound a solid";
    return {};
  }
  return Solid::from_leaf(result.leaf, one_thread);
}

inline Solid box(const Point3& low, const Point3& high) {
  return solid(shapes::box(low, high));
}

inline Solid operator|(const Solid& a, const Solid& b) {
  return unite(std::array{a, b}, one_thread);
}
inline Solid operator&(const Solid& a, const Solid& b) {
  return intersect(std::array{a, b}, one_thread);
}
inline Solid operator-(const Solid& a, const Solid& b) {
  return subtract(a, {&b, 1}, one_thread);
}
inline Solid operator^(const Solid& a, const Solid& b) {
  return symmetric_difference(std::array{a, b}, one_thread);
}
inline Solid operator~(const Solid& a) {
  return complement(a, one_thread);
}

inline Rational volume_of(const Solid& s) {
  return volume(s.boundary(), one_thread);
}

inline void expect_valid(const Brep& boundary) {
  for (const std::string& violation : check_boundary(boundary, 10, one_thread)) ADD_FAILURE() << violation;
}
inline void expect_valid(const Solid& s) {
  expect_valid(s.boundary());
}

/// Equal as sets: no point in one of them alone.
inline void expect_same_set(const Solid& a, const Solid& b) {
  EXPECT_TRUE((a ^ b).is_empty());
}

/// The counts of a solid: vertices, edges, faces, loops, shells, and the sum of its shells' genera.
struct Counts {
  long vertices;
  long edges;
  long faces;
  long loops;
  long shells;
  long genus;
  friend bool operator==(const Counts&, const Counts&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Counts& c) {
    return out << c.vertices << " " << c.edges << " " << c.faces << " " << c.loops << " " << c.shells << " " << c.genus;
  }
};

/// The genus by V - E + F - (L - F) - 2 (S - G) = 0; 0 where the boundary is no manifold.
inline Counts counts_of(const Brep& boundary) {
  const TopologyCounts t = count_topology(boundary);
  Counts c{static_cast<long>(t.vertices),
           static_cast<long>(t.edges),
           static_cast<long>(t.faces),
           static_cast<long>(t.loops),
           static_cast<long>(boundary.shells.size()),
           0};
  if (!t.is_manifold()) return c;
  const long doubled = 2 * c.shells - (c.vertices - c.edges + c.faces - (c.loops - c.faces));
  EXPECT_EQ(doubled % 2, 0);
  c.genus = doubled / 2;
  return c;
}
inline Counts counts_of(const Solid& s) {
  return counts_of(s.boundary());
}

/// A boundary with the faces of a mesh as they are, as one outer shell: nothing is checked.
inline Brep boundary_of_faces(const Mesh& mesh) {
  Brep b;
  b.points = Constructions(mesh.vertices);
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    b.face_planes.push_back({PointId{corners[0]}, PointId{corners[1]}, PointId{corners[2]}});
    for (const std::uint32_t c : corners) b.loop_vertices.push_back(PointId{c});
    b.loop_begin.push_back(static_cast<std::uint32_t>(b.loop_vertices.size()));
    b.face_first_loop.push_back(f + 1);
    b.origins.push_back({0, f});
    b.face_first_origin.push_back(f + 1);
    b.face_shells.push_back(0);
  }
  b.shells.push_back({false});
  b.component_count = 1;
  return b;
}

inline Place place_of(const Solid& s, const RationalPoint3& point) {
  return SolidLocator(s.boundary(), one_thread).locate(point).place;
}

}  // namespace quoin::testing
