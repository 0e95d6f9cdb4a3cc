// SPDX-License-Identifier: Apache-2.0
//
// Boundaries that are wrong in one way each, made from right ones.
#include "quoin/solid/boundary_crossings.h"

#include <gtest/gtest.h>

#include <array>

#include "quoin/io/exact_text.h"
#include "quoin/solid/check.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"

namespace quoin {
namespace {

const Context one_thread({.threads = 1});

// The boundary of meshes put side by side as shells, whether they cross or not.
Brep side_by_side(const std::vector<Mesh>& meshes) {
  const Mesh all = shapes::joined(meshes);
  Brep b;
  b.points = Constructions(all.vertices);
  for (std::size_t f = 0; f < all.face_count(); ++f) {
    const auto corners = all.face(f);
    b.face_planes.push_back({PointId{corners[0]}, PointId{corners[1]}, PointId{corners[2]}});
    for (const std::uint32_t c : corners) b.loop_vertices.push_back(PointId{c});
    b.loop_begin.push_back(static_cast<std::uint32_t>(b.loop_vertices.size()));
    b.face_first_loop.push_back(static_cast<std::uint32_t>(f + 1));
    b.origins.push_back({0, static_cast<std::uint32_t>(f)});
    b.face_first_origin.push_back(static_cast<std::uint32_t>(f + 1));
  }
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    b.shells.push_back({false});
    for (std::size_t f = 0; f < meshes[m].face_count(); ++f) b.face_shells.push_back(static_cast<std::uint32_t>(m));
  }
  b.component_count = static_cast<std::uint32_t>(meshes.size());
  return b;
}

std::string first_of(const Brep& b) {
  const auto found = check_boundary(b, 5, one_thread);
  return found.empty() ? "" : found.front();
}

bool mentions(const Brep& b, const std::string& words) {
  for (const std::string& line : check_boundary(b, 1000, one_thread)) {
    if (line.find(words) != std::string::npos) return true;
  }
  return false;
}

TEST(BoundaryCrossings, RightOnesPass) {
  EXPECT_EQ(first_of(side_by_side({shapes::cube(1)})), "");
  EXPECT_EQ(first_of(side_by_side({shapes::cube(1), shapes::translated(shapes::cube(1), {2, 0, 0})})), "");
  EXPECT_EQ(first_of(side_by_side({shapes::torus(12, 8, 2, 1)})), "");
}

TEST(BoundaryCrossings, CrossingShells) {
  const Brep b = side_by_side({shapes::cube(1), shapes::translated(shapes::cube(1), {0.5, 0.25, 0.125})});
  EXPECT_TRUE(mentions(b, "pierces"));
  EXPECT_TRUE(
      mentions(side_by_side({shapes::cube(1), shapes::translated(shapes::cube(1), {0.5, 0.5, 0})}), "crosses edge"));
  EXPECT_TRUE(
      mentions(side_by_side({shapes::cube(1), shapes::translated(shapes::cube(1), {0.5, 0, 0})}), "lies on edge"));
  EXPECT_TRUE(
      mentions(side_by_side({shapes::cube(2), shapes::translated(shapes::cube(1), {2, 0.5, 0.5})}), "runs inside"));
  EXPECT_TRUE(mentions(side_by_side({shapes::cube(1), shapes::translated(shapes::cube(1), {1, 0, 0})}),
                       "another face lies on"));
}

TEST(BoundaryCrossings, ShellsThatAreNotWhatTheySay) {
  const Mesh inner = shapes::translated(shapes::cube(1), {1, 1, 1});
  EXPECT_TRUE(mentions(side_by_side({shapes::cube(3), inner}), "outward side"));
  Brep hollow = side_by_side({shapes::cube(3), shapes::reversed(inner)});
  EXPECT_TRUE(mentions(hollow, "is declared an outer one"));
  hollow.shells[1].is_void = true;
  EXPECT_TRUE(mentions(hollow, "components are declared"));
  hollow.component_count = 1;
  EXPECT_EQ(first_of(hollow), "");
  Brep inverted = side_by_side({shapes::reversed(shapes::cube(1))});
  EXPECT_TRUE(mentions(inverted, "outward side"));
  inverted.is_unbounded = true;
  inverted.shells[0].is_void = true;
  EXPECT_EQ(first_of(inverted), "");
}

}  // namespace
}  // namespace quoin
