// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/alpha_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/topology/homology.h"
#include "quoin/triangulation/alpha_shape.h"
#include "quoin/triangulation/delaunay2.h"
#include "quoin/triangulation/delaunay3.h"
#include "quoin/triangulation/regular3.h"
#include "quoin/triangulation/test_clouds.h"

namespace quoin {
namespace {

using testing::Random;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

/// Cells of full dimension, joined by common facets: each list is merged with all that share one.
std::size_t slow_pieces(const AlphaComplex& alpha, std::uint32_t grades) {
  const int top = alpha.dimension();
  std::vector<std::vector<std::uint32_t>> facets_of_pieces;
  for (std::uint32_t i = 0; i < alpha.complex().count(top); ++i) {
    if (alpha.grade_of({top, i}) >= grades) continue;
    std::vector<std::uint32_t> merged;
    if (top > 0) merged.assign(alpha.complex().facets({top, i}).begin(), alpha.complex().facets({top, i}).end());
    for (std::size_t p = facets_of_pieces.size(); p-- > 0;) {
      std::vector<std::uint32_t>& other = facets_of_pieces[p];
      const bool touches = std::any_of(other.begin(), other.end(), [&](std::uint32_t f) {
        return std::find(merged.begin(), merged.end(), f) != merged.end();
      });
      if (!touches) continue;
      merged.insert(merged.end(), other.begin(), other.end());
      facets_of_pieces.erase(facets_of_pieces.begin() + static_cast<std::ptrdiff_t>(p));
    }
    facets_of_pieces.push_back(merged);
  }
  return facets_of_pieces.size();
}

bool has_all_vertices_at_cells(const AlphaComplex& alpha, std::uint32_t grades) {
  const int top = alpha.dimension();
  std::vector<bool> seen(alpha.complex().count(0));
  for (std::uint32_t i = 0; i < alpha.complex().count(top); ++i) {
    if (alpha.grade_of({top, i}) >= grades) continue;
    for (const std::uint32_t v : alpha.complex().vertices({top, i})) seen[v] = true;
  }
  return std::find(seen.begin(), seen.end(), false) == seen.end();
}

void check(const AlphaComplex& alpha) {
  std::vector<std::uint32_t> least(4, 0);  // grades with so many pieces
  for (std::uint32_t grades = 0; grades <= alpha.grade_count(); ++grades) {
    const SimplicialComplex part = alpha_subcomplex(alpha, grades, context());
    std::vector<std::size_t> betti = betti_numbers(part, 2, context());
    betti.resize(3);
    const std::array<std::size_t, 3> found = alpha_betti_numbers(alpha, grades, context());
    ASSERT_EQ(std::vector<std::size_t>(found.begin(), found.end()), betti) << grades;
    const std::size_t pieces = slow_pieces(alpha, grades);
    ASSERT_EQ(alpha_pieces(alpha, grades, context()), pieces) << grades;
    if (!has_all_vertices_at_cells(alpha, grades)) continue;
    for (std::size_t most = std::max<std::size_t>(pieces, 1); most < least.size(); ++most) {
      if (least[most] == 0) least[most] = grades;
    }
  }
  for (std::size_t most = 1; most < least.size(); ++most) {
    ASSERT_EQ(grades_with_pieces(alpha, most, context()), least[most]) << most;
  }
}

TEST(AlphaTopology, OfPointsOfSpaceByHomology) {
  Random random(1);
  for (int round = 0; round < test_rounds(6); ++round) {
    const auto coordinate = round % 2 == 0 ? &testing::unit : +[](Random& r) { return testing::small_integer(r, 3); };
    std::vector<Point3> points = testing::random_points(random, 14, coordinate);
    check(AlphaComplex(Delaunay3(points, context()), context()));
    std::vector<double> weights;
    for (std::size_t i = 0; i < points.size(); ++i) weights.push_back(0.1 * testing::unit(random));
    check(AlphaComplex(Regular3(points, weights, context()), context()));
    for (Point3& p : points) p.z = 1;
    check(AlphaComplex(Delaunay3(points, context()), context()));
    for (Point3& p : points) p.y = p.x;
    check(AlphaComplex(Delaunay3(points, context()), context()));
  }
  check(AlphaComplex(Delaunay3(std::vector<Point3>(3, Point3{1, 2, 3}), context()), context()));
}

TEST(AlphaTopology, OfPointsOfThePlaneByHomology) {
  Random random(2);
  for (int round = 0; round < test_rounds(8); ++round) {
    std::vector<Point2> points;
    for (int i = 0; i < 25; ++i) {
      points.push_back(round % 2 == 0 ? Point2{testing::unit(random), testing::unit(random)}
                                      : Point2{testing::small_integer(random, 4), testing::small_integer(random, 4)});
    }
    check(AlphaComplex(Delaunay2(points, {}, context()), context()));
  }
}

// Corners of two cubes far apart, the second of twice the size: they are filled at 3/4 and at 3 and become one at last.
TEST(AlphaTopology, TwoCubes) {
  std::vector<Point3> points;
  for (int i = 0; i < 8; ++i) {
    const Point3 corner{double(i & 1), double((i >> 1) & 1), double(i >> 2)};
    points.push_back(corner);
    points.push_back({100 + 2 * corner.x, 2 * corner.y, 2 * corner.z});
  }
  const AlphaComplex alpha(Delaunay3(points, context()), context());
  EXPECT_EQ(alpha.exact_value(grades_with_pieces(alpha, 2, context()) - 1), Rational(3));
  EXPECT_GT(alpha.exact_value(grades_with_pieces(alpha, 1, context()) - 1), Rational(2400));
  const auto betti = [&](double value) { return alpha_betti_numbers(alpha, alpha.grades_up_to(value), context()); };
  EXPECT_EQ(betti(0), (std::array<std::size_t, 3>{16, 0, 0}));
  EXPECT_EQ(betti(0.25), (std::array<std::size_t, 3>{9, 5, 0}));  // 12 edges of the first
  EXPECT_EQ(betti(0.5), (std::array<std::size_t, 3>{9, 0, 1}));   // its squares
  EXPECT_EQ(betti(0.75), (std::array<std::size_t, 3>{9, 0, 0}));
  EXPECT_EQ(betti(2), (std::array<std::size_t, 3>{2, 0, 1}));
}

TEST(AlphaTopology, RefusesNothingToFind) {
  const AlphaComplex alpha(Delaunay3(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}}, context()), context());
  EXPECT_THROW(grades_with_pieces(alpha, 0, context()), InputError);
}

}  // namespace
}  // namespace quoin
