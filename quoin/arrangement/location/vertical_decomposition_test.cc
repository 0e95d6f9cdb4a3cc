// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/location/vertical_decomposition.h"

#include <gtest/gtest.h>

#include <vector>

#include "quoin/arrangement/linear/linear_location.h"
#include "quoin/arrangement/location/location_scenes.h"
#include "quoin/arrangement/location/naive_locator.h"

namespace quoin {
namespace {

constexpr std::uint32_t none = PseudoTrapezoid::none;

VerticalDecomposition decompose(const LinearArrangement& a, bool walls_at_crossings = true) {
  return decompose_vertically(a, {walls_at_crossings}, Context());
}

TEST(VerticalDecomposition, CountsOfSegmentsInGeneralPosition) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const std::size_t n = 1 + 7 * seed;
    const LinearArrangement a = random_segments(n, 0.1 + 0.02 * seed, seed);
    const std::size_t crossings = a.counts().vertices - 2 * n;
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", " << crossings << " crossings");
    EXPECT_EQ(decompose(a).trapezoids.size(), 3 * n + 3 * crossings + 1);
    EXPECT_EQ(decompose(a, false).trapezoids.size(), 3 * n + crossings + 1);
    EXPECT_EQ(TrapezoidLocator<LinearFamily>(a).trapezoid_count(), 3 * n + 3 * crossings + 1);
  }
}

TEST(VerticalDecomposition, VerticesSeeWhatRaysMeet) {
  for (const Scene& scene : location_scenes()) {
    const LinearArrangement& a = scene.arrangement;
    const VerticalDecomposition d = decompose(a);
    const NaiveLocator<LinearFamily> naive(a);
    for (std::size_t i = 0; i < a.vertex_count(); ++i) {
      const dcel::VertexId v(i);
      if (!a.cells().is_real(v)) continue;
      SCOPED_TRACE(::testing::Message() << scene.name << ", vertex " << i);
      ASSERT_EQ(d.views[i].below, naive.shoot(a.point(v), Direction::down));
      ASSERT_EQ(d.views[i].above, naive.shoot(a.point(v), Direction::up));
    }
  }
}

/// Neighbours name each other and share what they should.
void check_neighbours(const std::vector<PseudoTrapezoid>& cells, bool has_walls_everywhere) {
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    const PseudoTrapezoid& cell = cells[i];
    SCOPED_TRACE(::testing::Message() << "cell " << i);
    if (cell.upper_right != none) {
      const PseudoTrapezoid& next = cells[cell.upper_right];
      ASSERT_EQ(next.upper_left, i);
      ASSERT_EQ(next.left, cell.right);
      ASSERT_EQ(next.face, cell.face);
      if (has_walls_everywhere) {
        ASSERT_EQ(next.top, cell.top);
      }
    }
    if (cell.lower_right != none) {
      const PseudoTrapezoid& next = cells[cell.lower_right];
      ASSERT_EQ(next.lower_left, i);
      ASSERT_EQ(next.left, cell.right);
      ASSERT_EQ(next.face, cell.face);
      if (has_walls_everywhere) {
        ASSERT_EQ(next.bottom, cell.bottom);
      }
    }
    if (cell.upper_left != none) {
      ASSERT_EQ(cells[cell.upper_left].upper_right, i);
    }
    if (cell.lower_left != none) {
      ASSERT_EQ(cells[cell.lower_left].lower_right, i);
    }
    if (cell.left.is_none()) {
      ASSERT_TRUE(cell.upper_left == none && cell.lower_left == none);
    }
  }
}

TEST(VerticalDecomposition, NeighboursAndFacesAgree) {
  for (const Scene& scene : location_scenes()) {
    SCOPED_TRACE(scene.name);
    const LinearArrangement& a = scene.arrangement;
    for (const bool walls_at_crossings : {true, false}) {
      const VerticalDecomposition d = decompose(a, walls_at_crossings);
      check_neighbours(d.trapezoids, walls_at_crossings);
      std::vector<bool> is_covered(a.face_count(), false);
      for (const PseudoTrapezoid& cell : d.trapezoids) {
        ASSERT_TRUE(a.cells().is_real(cell.face));
        if (cell.has_width) is_covered[cell.face.index()] = true;
        if (!cell.top.is_none()) {
          ASSERT_EQ(cell.face, a.cells().face(dcel::HalfedgeId(cell.top, true)));
        }
      }
      for (std::size_t f = 0; f < a.face_count(); ++f) {
        ASSERT_EQ(is_covered[f], a.cells().is_real(dcel::FaceId(f))) << "face " << f;
      }
    }
  }
}

}  // namespace
}  // namespace quoin
