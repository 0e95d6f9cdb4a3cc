// SPDX-License-Identifier: Apache-2.0
//
// Sums against the overlay of both Gaussian maps by the sweep of the sphere: another way to the same cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "quoin/arrangement/geodesic/geodesic_polygon_set.h"
#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/polytope/gaussian_map.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/test_sums.h"

namespace quoin {
namespace {

using namespace test_polytopes;

/// Regions are vertices of the sum, by the same two indices; what cuts an arc has two edges and is no facet.
void check_overlay(const Points& a, const Points& b) {
  const Polytope p = Polytope::hull_of(a, one_thread);
  const Polytope q = Polytope::hull_of(b, one_thread);
  const PolytopeSum sum = minkowski_sum(p, q, one_thread);
  const GaussianMap map_p = gaussian_map(p, one_thread);
  const GaussianMap map_q = gaussian_map(q, one_thread);
  const std::array<const GeodesicArrangement*, 2> sources{&map_p.arrangement, &map_q.arrangement};
  const Overlay<GeodesicFamily> both = overlay<GeodesicFamily>(sources, one_thread);
  const GeodesicArrangement& cells = both.arrangement();
  std::vector<std::array<std::uint32_t, 2>> labels;
  for (std::size_t f = 0; f < cells.face_count(); ++f) {
    const dcel::FaceId face(f);
    labels.push_back({map_p.vertex_of_face[both.source(face, 0).id], map_q.vertex_of_face[both.source(face, 1).id]});
  }
  std::sort(labels.begin(), labels.end());
  std::vector<std::array<std::uint32_t, 2>> expected = sum.vertices;
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(labels, expected);
  std::size_t cuts = 0;
  for (std::size_t v = 0; v < cells.vertex_count(); ++v) {
    cuts += cells.cells().degree(dcel::VertexId(v)) == 2 ? 1U : 0U;
  }
  if (sum.dimension == 3) {
    ASSERT_EQ(cells.vertex_count() - cuts, sum.facet_count());
    ASSERT_EQ(cells.edge_count() - cuts, sum.edge_count());
  }
  if (sum.dimension == 2) {
    ASSERT_EQ(cells.vertex_count() - cuts, 2U);
    ASSERT_EQ(cells.edge_count() - cuts, sum.edge_count());
  }
}

TEST(MapOverlay, HasTheCellsOfTheSphereSweep) {
  for (std::uint64_t seed = 0; seed < test_rounds(500U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Points a = seed % 2 == 0 ? on_a_small_grid(random, 4, 8) : on_a_small_flat(random, below(random, 4));
    Points b = seed % 3 == 0 ? on_a_small_grid(random, 4, 8) : on_a_small_flat(random, below(random, 4));
    if (seed % 7 == 0) b = scaled(a, seed % 2 == 0 ? -1 : 2);
    ASSERT_NO_FATAL_FAILURE(check_overlay(a, b));
  }
}

TEST(MapOverlay, HasThemInGeneralPosition) {
  for (std::uint64_t seed = 0; seed < test_rounds(20U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::normal_distribution<double> normal;
    const auto draw = [&] {
      Points points;
      for (int i = 0; i < 40; ++i) points.push_back({normal(random), normal(random), normal(random)});
      return points;
    };
    ASSERT_NO_FATAL_FAILURE(check_overlay(draw(), draw()));
  }
}

// One facet of as many edges as the vertex has whose region they leave: 4 * 10^8 signs, a second or more.
TEST(MapOverlay, MayBeCancelledWithinAFacet) {
  constexpr int count = tests_take_fewer_rounds ? 8000 : 20000;
  const auto cone = [](double apex, double turn) {
    Points points{{0, 0, apex}};
    for (int i = 0; i < count; ++i) {
      const double angle = turn + 2 * 3.14159265358979323846 / count * i;
      points.push_back({std::cos(angle), std::sin(angle), 0});
    }
    return Polytope::hull_of(points, one_thread);
  };
  const Polytope up = cone(1, 0);
  const Polytope down = cone(-1, 1e-5);
  for (const auto& [p, q] : {std::pair{&up, &down}, {&down, &up}}) {
    // A poll for every few hundred signs; without those within facets there are a few hundred in all.
    const Context context({.threads = 1, .most_polls = tests_take_fewer_rounds ? 10'000U : 100'000U});
    EXPECT_THROW(minkowski_sum(*p, *q, context), Cancelled);
  }
}

}  // namespace
}  // namespace quoin
