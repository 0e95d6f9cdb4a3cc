// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/patch_certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "quoin/base/test_rounds.h"
#include "quoin/solid/overlay/contacts.h"
#include "quoin/solid/shapes.h"

namespace quoin {
namespace {

const Context context;

// A body between a surface over a grid and the same surface lowered. `lift` gives a point from two parameters in
// [0, 1].
template <class Lift>
Mesh sheet(std::uint32_t n, std::uint32_t m, const Lift& lift) {
  Mesh mesh;
  for (const double lower : {0.0, 8.0}) {
    for (std::uint32_t i = 0; i <= n; ++i) {
      for (std::uint32_t j = 0; j <= m; ++j) {
        Point3 p = lift(static_cast<double>(i) / n, static_cast<double>(j) / m);
        p.z -= lower;
        mesh.vertices.push_back(p);
      }
    }
  }
  const std::uint32_t below = (n + 1) * (m + 1);
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i * (m + 1) + j; };
  const auto add_wall = [&](std::uint32_t a, std::uint32_t b) {
    mesh.add_face(Tile{a, below + a, below + b});
    mesh.add_face(Tile{a, below + b, b});
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const std::array<std::uint32_t, 4> q{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      mesh.add_face(Tile{q[0], q[1], q[2]});
      mesh.add_face(Tile{q[0], q[2], q[3]});
      mesh.add_face(Tile{below + q[0], below + q[2], below + q[1]});
      mesh.add_face(Tile{below + q[0], below + q[3], below + q[2]});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    add_wall(at(i, 0), at(i + 1, 0));
    add_wall(at(i + 1, m), at(i, m));
  }
  for (std::uint32_t j = 0; j < m; ++j) {
    add_wall(at(n, j), at(n, j + 1));
    add_wall(at(0, j + 1), at(0, j));
  }
  return mesh;
}

// A ring that goes around several times, its layers `pitch` apart, or through each other where the height swings.
Mesh ramp(double turns, double pitch, double swing) {
  return sheet(8, static_cast<std::uint32_t>(50 * turns), [&](double s, double t) {
    const double angle = 2 * std::numbers::pi * turns * t;
    const double radius = 1 + s;
    return Point3{radius * std::cos(angle), radius * std::sin(angle),
                  pitch * turns * t + swing * std::sin(angle / 2 + s)};
  });
}

Mesh rough_field(double shift, double height, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return sheet(40, 40, [&](double s, double t) {
    return Point3{40 * s + shift * uniform(random), 40 * t + shift * uniform(random), height * uniform(random)};
  });
}

struct Outcome {
  std::size_t patches = 0;
  std::size_t crossings = 0;
};

// Pairs of tiles that meet outside what they share, with and without those within patches.
Outcome compare(const Mesh& mesh) {
  const LeafResult result = make_leaf(mesh, {.max_listed = 0, .find_crossings = false}, context);
  if (!result.leaf) {
    ADD_FAILURE() << "not closed";
    return {};
  }
  const Leaf& leaf = *result.leaf;
  const Constructions points(leaf.vertices);
  const Patches patches = find_patches(leaf, points, context);
  const auto corners = [&](std::uint32_t t) {
    const Tile& tile = leaf.tiles[t];
    return overlay::Corners{PointId{tile[0]}, PointId{tile[1]}, PointId{tile[2]}};
  };
  const auto meet = [&](const TilePair& pair) {
    const overlay::Corners a = corners(pair.a);
    const overlay::Corners b = corners(pair.b);
    return overlay::have_equal_corners(points, a, b) || overlay::have_same_corners(a, b) ||
           overlay::have_contacts(points, a, b);
  };
  std::vector<TilePair> expected = leaf.tree.self_pairs({}, meet, context);
  std::vector<TilePair> found = leaf.tree.self_pairs({{}, patches.is_patch}, meet, context);
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
  for (const unsigned threads : {1U, 2U, 4U}) {
    const Patches again = find_patches(leaf, points, Context({.threads = threads}));
    EXPECT_EQ(again.is_patch, patches.is_patch);
    EXPECT_EQ(again.is_seam, patches.is_seam);
  }
  return {static_cast<std::size_t>(std::count(patches.is_patch.begin(), patches.is_patch.end(), 1)), expected.size()};
}

TEST(PatchCertificate, MostOfASmoothSurfaceIsInPatches) {
  const LeafResult sphere = make_leaf(shapes::geodesic_sphere(60), {}, context);
  const Patches patches = find_patches(*sphere.leaf, Constructions(sphere.leaf->vertices), context);
  EXPECT_LT(5 * std::count(patches.is_seam.begin(), patches.is_seam.end(), 1),
            static_cast<std::ptrdiff_t>(patches.is_seam.size()));
}

// Seen from above, all tiles turn the same way and several lie over one point.
TEST(PatchCertificate, LayersOverOneAnotherAreNoPatch) {
  std::size_t patches = 0;
  for (const double scale : {1.0, 0x1p100}) {
    if (tests_take_fewer_rounds && scale > 1) break;
    for (const double turns : {0.5, 1.0, 2.0, 3.5}) {
      for (const double pitch : {0.0, 0.01, 0.5}) {
        SCOPED_TRACE(::testing::Message() << scale << " turns " << turns << " pitch " << pitch);
        const Vector3 by{scale, scale, scale};
        patches += compare(shapes::scaled(ramp(turns, pitch, 0), by)).patches;
        const Outcome swinging = compare(shapes::scaled(ramp(turns, pitch, 0.3), by));
        patches += swinging.patches;
        if (turns > 1 && pitch < 0.5) {
          EXPECT_GT(swinging.crossings, 0U);
        }
      }
    }
  }
  EXPECT_GT(patches, test_cases(100U));
}

TEST(PatchCertificate, NeverHidesACrossingOfARoughSurface) {
  std::size_t patches = 0;
  std::size_t crossings = 0;
  for (std::uint64_t seed = 0; seed < test_rounds(12U); ++seed) {
    for (const double shift : {0.0, 0.2, 0.4, 0.7, 3.0}) {
      const Outcome outcome = compare(rough_field(shift, seed % 2 == 0 ? 0.1 : 1.0, seed));
      patches += outcome.patches;
      crossings += outcome.crossings;
    }
  }
  EXPECT_GT(patches, test_cases(100U));
  EXPECT_GT(crossings, test_cases(100U));
}

// Rims run along lines of the grid, and edges of it follow each other on one line.
TEST(PatchCertificate, FlatGridsArePatches) {
  const Mesh grid = sheet(64, 64, [](double s, double t) { return Point3{64 * s, 64 * t, 0}; });
  const Outcome outcome = compare(grid);
  EXPECT_GT(outcome.patches, 0U);
  EXPECT_EQ(outcome.crossings, 0U);
}

// The rim of one piece lies within that of the other, whose tiles it crosses without touching its rim.
TEST(PatchCertificate, PiecesOverOneAnotherAreNoPatch) {
  const Mesh wide = sheet(24, 24, [](double s, double t) { return Point3{24 * s, 24 * t, 0}; });
  const Mesh narrow = sheet(8, 8, [](double s, double t) { return Point3{8.3 + 7 * s, 8.2 + 7 * t, s - 0.5}; });
  EXPECT_GT(compare(shapes::joined({wide, narrow})).crossings, 0U);
}

TEST(PatchCertificate, SolidsInOneAnotherAndCopies) {
  const Mesh sphere = shapes::geodesic_sphere(8);
  compare(shapes::joined({sphere, sphere}));
  compare(shapes::joined({sphere, shapes::translated(sphere, {0.01, 0.02, 0.005})}));
  compare(shapes::joined({shapes::torus(40, 20, 2, 0.5), shapes::torus(40, 20, 2, 0.51)}));
}

}  // namespace
}  // namespace quoin
