// SPDX-License-Identifier: Apache-2.0
//
// Crossings found by pairs: all of them, against a scan of all pairs with the predicates of the concept; and the sweep
// that is given them makes what it makes without.
#include "quoin/arrangement/sweep/crossing_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "quoin/arrangement/arrangement_impl.h"
#include "quoin/arrangement/circle_scenes.h"
#include "quoin/arrangement/circular/circular_arrangement.h"
#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using Random = std::mt19937_64;
using arrangement_detail::CrossingSearch;

const Context one_thread({.threads = 1});

int below(Random& random, int end) {
  return static_cast<int>(random() % static_cast<std::uint64_t>(end));
}

template <class F>
struct Scene {
  F family;
  PieceList<F> list;
};

template <class F>
bool is_inside(const Scene<F>& scene, const typename F::Point& p, const Piece& piece) {
  return scene.family.compare_xy(scene.list.points[piece.left], p) == Sign::negative &&
         scene.family.compare_xy(p, scene.list.points[piece.right]) == Sign::negative;
}

template <class F>
bool any_overlap(const Scene<F>& scene) {
  const F& f = scene.family;
  const auto& list = scene.list;
  for (const Piece& a : list.pieces) {
    for (const Piece& b : list.pieces) {
      if (&a == &b || !f.same_branch(a.branch, b.branch)) continue;
      if (f.compare_xy(list.points[a.left], list.points[b.right]) == Sign::negative &&
          f.compare_xy(list.points[b.left], list.points[a.right]) == Sign::negative) {
        return true;
      }
    }
  }
  return false;
}

/// One circle or line under two numbers.
bool has_support_twice(const Scene<CircularFamily>& scene) {
  const CircularFamily& f = scene.family;
  for (const Piece& a : scene.list.pieces) {
    for (const Piece& b : scene.list.pieces) {
      const CircularSupportId one = f.support(a.branch);
      const CircularSupportId two = f.support(b.branch);
      if (one == two || f.is_line(one) != f.is_line(two)) continue;
      if (f.is_line(one)) {
        if (f.same_branch(a.branch, b.branch)) return true;
        continue;
      }
      const RationalCircle p = f.circle(one);
      const RationalCircle q = f.circle(two);
      if (p.x == q.x && p.y == q.y && p.squared_radius == q.squared_radius) return true;
    }
  }
  return false;
}
bool has_support_twice(const Scene<GeodesicFamily>& /*scene*/) {
  return false;
}

/// By all pairs.
template <class F>
CrossingList<typename F::Point> all_crossings(const Scene<F>& scene) {
  CrossingList<typename F::Point> result;
  const auto& pieces = scene.list.pieces;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    for (std::uint32_t k = i + 1; k < pieces.size(); ++k) {
      if (scene.family.same_branch(pieces[i].branch, pieces[k].branch)) continue;
      std::vector<Meeting<typename F::Point>> common;
      scene.family.meetings(pieces[i].branch, pieces[k].branch, common);
      for (const auto& meeting : common) {
        if (!is_inside(scene, meeting.point, pieces[i]) || !is_inside(scene, meeting.point, pieces[k])) continue;
        result.add(meeting.point, {i, k, meeting.crosses});
      }
    }
  }
  return result;
}

/// Indices, by pair and then from left to right; numbers of a pair in ascending order.
template <class F>
std::vector<std::size_t> put_in_order(const F& family, CrossingList<typename F::Point>& list) {
  std::vector<std::size_t> order(list.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
    if (list.pairs[i].two < list.pairs[i].one) std::swap(list.pairs[i].one, list.pairs[i].two);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const PiecePair& p = list.pairs[a];
    const PiecePair& q = list.pairs[b];
    if (p.one != q.one) return p.one < q.one;
    if (p.two != q.two) return p.two < q.two;
    return family.compare_xy(list.points[a], list.points[b]) == Sign::negative;
  });
  return order;
}

/// Scenes below the fewest trials that are ever given up.
template <class F>
void check_crossings(const Scene<F>& scene) {
  CrossingList<typename F::Point> found;
  if (!scene.family.find_crossings(scene.list, one_thread, found)) {
    ASSERT_TRUE(any_overlap(scene) || has_support_twice(scene)) << "declined without reason";
    return;
  }
  ASSERT_FALSE(any_overlap(scene));
  CrossingList<typename F::Point> expected = all_crossings(scene);
  ASSERT_EQ(found.points.size(), expected.points.size());
  const std::vector<std::size_t> mine = put_in_order(scene.family, found);
  const std::vector<std::size_t> theirs = put_in_order(scene.family, expected);
  for (std::size_t i = 0; i < mine.size(); ++i) {
    const PiecePair& p = found.pairs[mine[i]];
    const PiecePair& q = expected.pairs[theirs[i]];
    ASSERT_EQ(p.one, q.one);
    ASSERT_EQ(p.two, q.two);
    ASSERT_EQ(p.crosses, q.crosses);
    ASSERT_EQ(scene.family.compare_xy(found.points[mine[i]], expected.points[theirs[i]]), Sign::zero);
  }
}

template <class F>
Arrangement<F> arrange_by(const Scene<F>& scene, CrossingSearch search) {
  return arrangement_detail::arrange_sorted(scene.family, sorted_list(one_thread, scene.family, scene.list), search,
                                            one_thread);
}

template <class F>
void check_arrangements(const Scene<F>& scene) {
  const Arrangement<F> a = arrange_by(scene, CrossingSearch::as_fits);
  const Arrangement<F> b = arrange_by(scene, CrossingSearch::along_the_sweep);
  dcel::check_links(a.cells());
  ASSERT_EQ(a.vertex_count(), b.vertex_count());
  ASSERT_EQ(a.edge_count(), b.edge_count());
  ASSERT_EQ(a.face_count(), b.face_count());
  for (std::size_t i = 0; i < a.cells().halfedges.size(); ++i) {
    const dcel::Halfedge& g = a.cells().halfedges[i];
    const dcel::Halfedge& h = b.cells().halfedges[i];
    ASSERT_EQ(g.next, h.next);
    ASSERT_EQ(g.origin, h.origin);
    ASSERT_EQ(g.boundary, h.boundary);
  }
  for (std::size_t i = 0; i < a.cells().boundaries.size(); ++i) {
    ASSERT_EQ(a.cells().boundaries[i].face, b.cells().boundaries[i].face);
    ASSERT_EQ(a.cells().boundaries[i].is_outer, b.cells().boundaries[i].is_outer);
  }
  for (std::size_t i = 0; i < a.vertex_count(); ++i) {
    const dcel::VertexId v(i);
    ASSERT_EQ(a.cells().is_isolated(v), b.cells().is_isolated(v));
    if (!a.has_point(v)) continue;
    ASSERT_EQ(a.family().compare_xy(a.point(v), b.point(v)), Sign::zero);
  }
  for (std::size_t i = 0; i < a.edge_count(); ++i) {
    const dcel::EdgeId e(i);
    ASSERT_EQ(a.branch(e), b.branch(e));
    ASSERT_TRUE(std::ranges::equal(a.curves(e), b.curves(e)));
  }
}

// ---- Circles, arcs and segments ----

using Circular = Scene<CircularFamily>;

/// On a small grid nearly everything coincides: circles that touch, three through a point, ends on other curves.
Circular on_a_grid(Random& random, int curves, int size) {
  Circular scene;
  CircularFamily& f = scene.family;
  const auto point = [&] { return Point2{double(below(random, size)), double(below(random, size))}; };
  for (int i = 0; i < curves; ++i) {
    const Point2 centre = point();
    const double radius = 1 + below(random, size / 2);
    const Point2 right{centre.x + radius, centre.y};
    const Point2 top{centre.x, centre.y + radius};
    switch (below(random, 4)) {
      case 0: {
        const Point2 a = point();
        const Point2 b = point();
        if (a != b) f.add_segment(scene.list, a, b);
        break;
      }
      case 1:
        f.add_arc(scene.list, centre, radius, right, top, CircularFamily::Direction::counterclockwise);
        break;
      case 2:
        f.add_arc(scene.list, centre, radius, right, top, CircularFamily::Direction::clockwise);
        break;
      default:
        f.add_circle(scene.list, centre, radius);
    }
  }
  return scene;
}

Circular anywhere(Random& random, int circles) {
  std::uniform_real_distribution<double> coordinate(0, 1);
  Circular scene;
  for (int i = 0; i < circles; ++i) {
    scene.family.add_circle(scene.list, {coordinate(random), coordinate(random)}, 0.1 + 0.4 * coordinate(random));
  }
  return scene;
}

TEST(CrossingList, OfCirclesAndSegmentsOnSmallGrids) {
  std::size_t overlaps = 0;
  for (std::uint64_t seed = 0; seed < test_rounds(2000U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Circular scene = on_a_grid(random, 1 + below(random, 12), 3 + below(random, 20));
    overlaps += any_overlap(scene) ? 1U : 0U;
    ASSERT_NO_FATAL_FAILURE(check_crossings(scene));
    ASSERT_NO_FATAL_FAILURE(check_arrangements(scene));
  }
  EXPECT_GT(overlaps, test_cases(20U));
  EXPECT_LT(overlaps, 1500U);
}

TEST(CrossingList, OfScenesOf14Circles) {
  for (const testing::CircleScene& circles : testing::scenes_of_14_circles()) {
    Circular scene;
    for (const auto& [x, y, r] : circles) {
      scene.family.add_circle(scene.list, {double(x), double(y)}, double(r));
    }
    ASSERT_NO_FATAL_FAILURE(check_crossings(scene));
    ASSERT_NO_FATAL_FAILURE(check_arrangements(scene));
  }
}

TEST(CrossingList, OfCirclesAnywhere) {
  for (std::uint64_t seed = 0; seed < test_rounds(10U); ++seed) {
    Random random(seed);
    const Circular scene = anywhere(random, 30);
    ASSERT_NO_FATAL_FAILURE(check_crossings(scene));
    ASSERT_NO_FATAL_FAILURE(check_arrangements(scene));
  }
}

TEST(CrossingList, ConcentricEqualAndTouchingCircles) {
  Circular scene;
  CircularFamily& f = scene.family;
  for (const double radius : {1.0, 2.0, 3.0}) f.add_circle(scene.list, {0, 0}, radius);
  f.add_circle(scene.list, {1, 0}, 1);  // touches two from inside
  f.add_circle(scene.list, {0, 3}, 1);  // touches one from outside, crosses another
  f.add_segment(scene.list, Point2{-3, 2}, Point2{3, 2});
  ASSERT_NO_FATAL_FAILURE(check_crossings(scene));
  ASSERT_NO_FATAL_FAILURE(check_arrangements(scene));
  f.add_circle(scene.list, {0, 0}, 2);  // once more
  CrossingList<CircularPoint> out;
  EXPECT_FALSE(f.find_crossings(scene.list, one_thread, out));
  ASSERT_NO_FATAL_FAILURE(check_arrangements(scene));
}

TEST(CrossingList, IsDeclinedWhereFewPairsMeet) {
  Circular scene;
  for (int i = 0; i < 4000; ++i) {
    scene.family.add_circle(scene.list, {double(i % 20), double(3 * i)}, 1.25);
  }
  CrossingList<CircularPoint> out;
  EXPECT_FALSE(scene.family.find_crossings(scene.list, one_thread, out));
}

// ---- Arcs of great circles ----

using Geodesic = Scene<GeodesicFamily>;

/// Directions with small components: poles, the identification, meridians and many through one point.
Geodesic of_small_directions(Random& random, int curves, int size) {
  Geodesic scene;
  const auto direction = [&] {
    for (;;) {
      std::array<int, 3> d{};
      for (int& c : d) c = below(random, 2 * size + 1) - size;
      if (d[0] != 0 || d[1] != 0 || d[2] != 0)
        return SphereDirection(Vector3{double(d[0]), double(d[1]), double(d[2])});
    }
  };
  for (int i = 0; i < curves; ++i) {
    if (below(random, 3) == 0) {
      scene.family.add_great_circle(scene.list, direction());
      continue;
    }
    const SphereDirection source = direction();
    const SphereDirection target = direction();
    try {
      scene.family.add_arc(scene.list, source, target);
    } catch (const InputError&) {  // equal or antipodal ends
      scene.family.add_point(scene.list, source);
    }
  }
  return scene;
}

TEST(CrossingList, OfGeodesicsWithSmallDirections) {
  std::size_t overlaps = 0;
  for (std::uint64_t seed = 0; seed < test_rounds(3000U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Geodesic scene = of_small_directions(random, 1 + below(random, 12), 1 + below(random, 9));
    overlaps += any_overlap(scene) ? 1U : 0U;
    ASSERT_NO_FATAL_FAILURE(check_crossings(scene));
    ASSERT_NO_FATAL_FAILURE(check_arrangements(scene));
  }
  EXPECT_GT(overlaps, test_cases(20U));
  EXPECT_LT(overlaps, 2000U);
}

TEST(CrossingList, OfGreatCirclesAndLongArcs) {
  for (std::uint64_t seed = 0; seed < test_rounds(20U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Geodesic scene = of_small_directions(random, 25, 1 << 20);
    ASSERT_NO_FATAL_FAILURE(check_crossings(scene));
    ASSERT_NO_FATAL_FAILURE(check_arrangements(scene));
  }
}

}  // namespace
}  // namespace quoin
