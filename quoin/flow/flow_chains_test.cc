// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/test_rounds.h"
#include "quoin/flow/flow_graph.h"
#include "quoin/flow/stable_surface.h"
#include "quoin/flow/test_flow.h"
#include "quoin/flow/test_scans.h"
#include "quoin/flow/unstable_arcs.h"
#include "quoin/topology/homology.h"
#include "quoin/triangulation/voronoi.h"

namespace quoin {
namespace {

using testing::flow_complex;
using testing::Random;
using Counts = std::array<std::size_t, 4>;
using Simplex = std::vector<std::uint32_t>;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

/// Centre of the smallest sphere through up to four points.
RationalPoint3 centre(const std::vector<Point3>& p) {
  const RationalPoint3 a = exact_point(p[0]);
  if (p.size() == 1) return a;
  if (p.size() == 4) return circumcentre(p[0], p[1], p[2], p[3]);
  const RationalPoint3 u = exact_point(p[1]) - a;
  if (p.size() == 2) return a + u * (Rational(1) / Rational(2));
  const RationalPoint3 v = exact_point(p[2]) - a;
  // x = s u + r v with x . u = u . u / 2 and x . v = v . v / 2.
  const Rational uu = dot(u, u);
  const Rational uv = dot(u, v);
  const Rational vv = dot(v, v);
  const Rational twice = Rational(2) * (uu * vv - uv * uv);
  return a + u * ((uu * vv - uv * vv) / twice) + v * ((vv * uu - uv * uu) / twice);
}

/// Simplices of the Delaunay triangulation with the least squared radius at which the union of balls has them.
std::map<Simplex, Rational> alpha_values(const Delaunay3& t) {
  std::map<Simplex, Rational> values;
  const auto size = static_cast<std::size_t>(t.dimension()) + 1;
  for (std::size_t k = size; k > 0; --k) {
    for (std::size_t c = 0; c < t.cells().size(); ++c) {
      if (t.is_ghost(c)) continue;
      for (unsigned mask = 1; mask < 1U << size; ++mask) {
        Simplex simplex;
        std::vector<Point3> points;
        for (std::size_t i = 0; i < size; ++i) {
          if ((mask >> i & 1) != 0) simplex.push_back(t.cells()[c].vertices[i]);
        }
        if (simplex.size() != k) continue;
        std::sort(simplex.begin(), simplex.end());
        for (const std::uint32_t v : simplex) points.push_back(t.point(v));
        const RationalPoint3 z = centre(points);
        const RationalPoint3 r = z - exact_point(points[0]);
        bool is_empty = true;
        for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
          const RationalPoint3 to = z - exact_point(t.point(v));
          is_empty &= dot(to, to) >= dot(r, r);
        }
        if (is_empty) values[simplex] = dot(r, r);
        const Rational value = values.at(simplex);
        for (std::size_t i = 0; i < k && k > 1; ++i) {
          Simplex face = simplex;
          face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
          const auto [at, is_new] = values.try_emplace(face, value);
          if (!is_new && value < at->second) at->second = value;
        }
      }
    }
  }
  return values;
}

/// Hollows that are cut off and not yet filled.
std::size_t open_pairs(const FlowGraph& graph, const Rational& level) {
  const std::vector<FlowGraph::Pair> pairs = graph.pairs(context());
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [&](const FlowGraph::Pair& pair) {
    return graph.exact_square_of_saddle(pair.saddle) <= level && level < graph.exact_square_of_maximum(pair.maximum);
  }));
}

/// At all critical values and between: the Betti numbers of the union of balls. Of chains that are not ordinary only
/// the alternating sums.
void check_levels(const std::vector<Point3>& points) {
  const Delaunay3 triangulation(points, context());
  const FlowComplex flow(triangulation, context());
  const FlowChains chains = flow_chains(flow, context());
  const std::map<Simplex, Rational> values = alpha_values(triangulation);
  std::optional<FlowCells> cells;
  std::optional<FlowGraph> graph;
  if (triangulation.dimension() == 3) graph.emplace(cells.emplace(triangulation, context()), context());
  std::set<Rational> levels;
  for (const DeloneFace& face : flow.faces_of_kind(FlowKind::critical)) levels.insert(flow.square_radius(face));
  for (const auto& [simplex, value] : values) levels.insert(value);
  for (const Rational& level : levels) {
    SimplexList list;
    for (const auto& [simplex, value] : values) {
      if (value <= level) list.add(simplex);
    }
    std::vector<std::size_t> expected = betti_numbers(SimplicialComplex::closure_of(list, context()), 2, context());
    expected.resize(4, 0);
    if (chains.is_ordinary()) {
      const Counts found = flow_betti_numbers(flow, chains, &level);
      ASSERT_EQ(std::vector<std::size_t>(found.begin(), found.end()), expected);
    }
    if (graph) {
      const std::array<std::size_t, 3> found = graph->betti_numbers(level, context());
      ASSERT_EQ((std::vector<std::size_t>{found[0], found[1], found[2], 0}), expected);
      ASSERT_EQ(open_pairs(*graph, level), expected[2]);
    }
    long sum = 0;
    for (const DeloneFace& face : flow.faces_of_kind(FlowKind::critical)) {
      if (flow.square_radius(face) <= level) sum += face.dimension % 2 == 0 ? 1 : -1;
    }
    ASSERT_EQ(sum, static_cast<long>(expected[0] + expected[2]) - static_cast<long>(expected[1] + expected[3]));
  }
}

TEST(FlowChains, BettiNumbersOfUnionsOfBalls) {
  Random random(95);
  for (int round = 0; round < test_rounds(6); ++round) {
    check_levels(testing::random_points(random, 9 + random() % 6, testing::unit));
  }
  for (int round = 0; round < test_rounds(12); ++round) {
    check_levels(testing::random_points(random, 10, [](Random& r) { return testing::small_integer(r, 2); }));
  }
  for (const testing::Cloud& scan : testing::rounded_scans(random, 12)) {
    SCOPED_TRACE(scan.name);
    check_levels(scan.points);
  }
  check_levels(testing::lattice(2, 2, 2));
  check_levels({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
}

// Less than half a step of noise on grids: the same sum, and nothing is out of the ordinary any more.
TEST(FlowChains, NoiseMakesGridsOrdinary) {
  Random random(96);
  for (int round = 0; round < test_rounds(20); ++round) {
    std::vector<Point3> points =
        round % 4 == 0 ? testing::rounded_scan(random, 60, testing::scanned_sphere)
                       : testing::random_points(random, 15, [](Random& r) { return testing::small_integer(r, 2); });
    for (Point3& p : points) {
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] += 0.3 * testing::unit(random);
    }
    const FlowComplex flow = flow_complex(points);
    const FlowChains chains = flow_chains(flow, context());
    ASSERT_TRUE(chains.is_ordinary());
    ASSERT_TRUE(is_chain_complex(chains));
    ASSERT_EQ(flow_betti_numbers(flow, chains), (Counts{1, 0, 0, 0}));
  }
}

// An edge with a point in the closed ball over it is no edge of a minimum spanning tree.
TEST(FlowChains, CriticalEdgesHaveMinimumSpanningTrees) {
  Random random(97);
  for (const testing::Cloud& cloud : testing::flow_clouds(random, 25)) {
    SCOPED_TRACE(cloud.name);
    const FlowComplex flow = flow_complex(cloud.points);
    const auto n = static_cast<std::uint32_t>(flow.faces().count(0));
    std::map<Rational, std::vector<std::array<std::uint32_t, 2>>> by_length;
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        const RationalPoint3 v = exact_point(flow.point(i)) - exact_point(flow.point(j));
        by_length[dot(v, v)].push_back({j, i});
      }
    }
    DisjointSets sets(n);
    for (const auto& [length, pairs] : by_length) {
      for (const auto& [i, j] : pairs) {
        if (sets.find(i) == sets.find(j)) continue;
        sets.unite(i, j);
        bool is_critical = false;
        for (const std::uint32_t e : flow.faces().edges_of_vertex(i)) {
          is_critical |= flow.faces().edge(e) == std::array{i, j} && flow.is_critical({1, e});
        }
        ASSERT_TRUE(is_critical);
      }
    }
  }
}

TEST(FlowChains, FilteredAndExactNumbersAgree) {
  Random random(98);
  std::size_t undecided = 0;
  for (const testing::Cloud& cloud : testing::flow_clouds(random, 22)) {
    SCOPED_TRACE(cloud.name);
    const FlowComplex flow = flow_complex(cloud.points);
    ArcTracer filtered(flow);
    ArcTracer exact(flow, AtRegularPoint::pass, FlowNumbers::exact);
    for (const DeloneFace& face : flow.faces_of_kind(FlowKind::critical)) {
      if (face.dimension != 2) continue;
      const StableSurface a = stable_surface(flow, face.index, context());
      const StableSurface b = stable_surface(flow, face.index, context(), FlowNumbers::exact);
      undecided += a.points.exact_count();
      ASSERT_EQ(a.points.size(), b.points.size());
      for (std::uint32_t i = 0; i < a.points.size(); ++i) ASSERT_EQ(a.points.face(i), b.points.face(i));
      const UnstableArcs c = filtered.trace(face.index, context());
      const UnstableArcs d = exact.trace(face.index, context());
      for (std::size_t side = 0; side < 2; ++side) {
        ASSERT_EQ(c.arcs[side].end, d.arcs[side].end);
        ASSERT_EQ(c.arcs[side].segments, d.arcs[side].segments);
        ASSERT_EQ(c.arcs[side].is_infinite, d.arcs[side].is_infinite);
      }
    }
    undecided += filtered.exact_count();
  }
  EXPECT_GT(undecided, 0U);
}

}  // namespace
}  // namespace quoin
