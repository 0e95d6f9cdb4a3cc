// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/critical_separation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/flow/flow_complex.h"
#include "quoin/flow/test_scans.h"

namespace quoin {
namespace {

using testing::Random;
using Vertices = std::vector<std::uint32_t>;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

using Places = std::map<Vertices, bool>;

/// The definition, in rationals, over all Delone faces.
class SlowSeparation {
 public:
  explicit SlowSeparation(const Delaunay3& triangulation) : flow_(triangulation, context()), faces_(flow_.faces()) {
    const std::size_t count = faces_.count(0);
    poles_.resize(count);
    for (std::uint32_t v = 0; v < count; ++v) poles_[v] = hull_direction(v);
    std::vector<bool> is_inner(count);
    for (std::uint32_t v = 0; v < count; ++v) is_inner[v] = poles_[v] == RationalPoint3{};
    std::vector<std::optional<std::tuple<Rational, Rational, Rational, Rational>>> best(count);
    for (std::uint32_t c = 0; c < faces_.count(3); ++c) {
      const RationalPoint3 centre = flow_.centre({3, c});
      const auto key = std::tuple(flow_.square_radius({3, c}), centre.x, centre.y, centre.z);
      for (const std::uint32_t v : faces_.cell(c)) {
        if (!is_inner[v] || (best[v] && *best[v] >= key)) continue;
        best[v] = key;
        poles_[v] = centre - at(v);
      }
    }
  }

  /// By sorted vertices: whether a critical point is medial.
  Places places() const {
    Places all;
    for (const DeloneFace face : flow_.faces_of_kind(FlowKind::critical)) {
      if (face.dimension == 0) continue;
      const std::span<const std::uint32_t> span = faces_.vertices(face);
      Vertices vertices(span.begin(), span.end());
      std::sort(vertices.begin(), vertices.end());
      std::size_t medial = 0;
      for (const std::uint32_t v : vertices) medial += is_medial(flow_.centre(face) - at(v), poles_[v]) ? 1 : 0;
      all.emplace(vertices, 2 * medial > vertices.size());
    }
    return all;
  }

 private:
  RationalPoint3 at(std::uint32_t v) const { return exact_point(flow_.point(v)); }

  static bool is_medial(const RationalPoint3& way, const RationalPoint3& pole) {
    const Rational along = dot(way, pole);
    return along * along * Rational(2) > dot(way, way) * dot(pole, pole);
  }
  RationalPoint3 hull_direction(std::uint32_t v) const {
    RationalPoint3 sum;
    for (std::uint32_t f = 0; f < faces_.count(2); ++f) {
      const auto [inner, outer] = faces_.cells_of_polygon(f);
      if (inner != DeloneFaces::outside && outer != DeloneFaces::outside) continue;
      const std::span<const std::uint32_t> corners = faces_.polygon(f);
      if (std::find(corners.begin(), corners.end(), v) == corners.end()) continue;
      const Rational turn(inner == DeloneFaces::outside ? -1 : 1);
      for (std::size_t i = 2; i < corners.size(); ++i) {
        sum = sum + cross(at(corners[i - 1]) - at(corners[0]), at(corners[i]) - at(corners[0])) * turn;
      }
    }
    return sum;
  }

  FlowComplex flow_;
  const DeloneFaces& faces_;
  std::vector<RationalPoint3> poles_;
};

/// The same of what was found.
Places places_of(const FlowGraph& graph, const CriticalSeparation& found) {
  const FlowCells& flow = graph.cells();
  Places all;
  std::size_t edges = 0;
  flow.for_each_critical_edge(context(), [&](std::uint32_t cell, unsigned edge) {
    const std::array<std::uint32_t, 4>& corners = flow.cells()[cell].vertices;
    Vertices ends{corners[edge_slots[edge][0]], corners[edge_slots[edge][1]]};
    std::sort(ends.begin(), ends.end());
    all.emplace(ends, found.edges[edges++]);
  });
  for (std::size_t i = 0; i < graph.saddles().size(); ++i) {
    all.emplace(flow.vertices_of_polygon(graph.saddles()[i].facet), found.saddles[i]);
  }
  for (std::size_t i = 0; i < graph.maxima().size(); ++i) {
    all.emplace(flow.vertices_of(graph.maxima()[i].cell), found.maxima[i]);
  }
  EXPECT_EQ(edges, found.edges.size());
  return all;
}

struct Separated {
  Delaunay3 triangulation;
  FlowCells cells;
  FlowGraph graph;
  CriticalSeparation separation;

  explicit Separated(const std::vector<Point3>& points)
      : triangulation(points, context()),
        cells(triangulation, context()),
        graph(cells, context()),
        separation(separate(graph, context())) {}
  SeparatedSolid solid() const { return separated_solid(graph, separation, context()); }
};

TEST(CriticalSeparation, IsTheDefinitionInRationals) {
  Random random(211);
  std::size_t medial = 0;
  std::size_t of_surface = 0;
  std::size_t disputed = 0;
  for (int round = 0; round < test_rounds(3); ++round) {
    for (const testing::Cloud& cloud : testing::flow_clouds(random, 24)) {
      SCOPED_TRACE(cloud.name);
      if (Delaunay3(cloud.points, context()).dimension() < 3) continue;
      const Separated fast(cloud.points);
      const Places found = places_of(fast.graph, fast.separation);
      EXPECT_EQ(found, SlowSeparation(fast.triangulation).places());
      const auto& told = fast.separation.medial;
      const auto count = static_cast<std::size_t>(
          std::count_if(found.begin(), found.end(), [](const auto& place) { return place.second; }));
      EXPECT_EQ(count, told[1] + told[2] + told[3]);
      medial += count;
      of_surface += found.size() - count;
      for (const std::size_t of_index : fast.separation.disputed) disputed += of_index;
    }
  }
  EXPECT_GE(medial, test_cases(50U));
  EXPECT_GE(of_surface, test_cases(50U));
  EXPECT_GE(disputed, test_cases(50U));
}

/// Whether each critical point is medial, by the coordinates of its nearest points.
std::map<std::vector<std::array<double, 3>>, bool> by_coordinates(const std::vector<Point3>& points, double scale) {
  const Separated all(points);
  std::map<std::vector<std::array<double, 3>>, bool> named;
  for (const auto& [vertices, is_medial] : places_of(all.graph, all.separation)) {
    std::vector<std::array<double, 3>> name;
    for (const std::uint32_t v : vertices) {
      const Point3 p = all.triangulation.point(v);
      name.push_back({p.x / scale, p.y / scale, p.z / scale});
    }
    std::sort(name.begin(), name.end());
    named.emplace(name, is_medial);
  }
  return named;
}

TEST(CriticalSeparation, DoesNotDependOnOrderOrScale) {
  Random random(212);
  std::vector<std::vector<Point3>> all{testing::lattice(4, 3, 3), testing::cospherical(),
                                       testing::near_sphere(random, 60)};
  all.push_back(testing::random_points(random, 60, [](Random& r) { return testing::small_integer(r, 3); }));
  for (std::vector<Point3>& points : all) {
    const auto before = by_coordinates(points, 1);
    std::shuffle(points.begin(), points.end(), random);
    EXPECT_EQ(by_coordinates(points, 1), before);
    for (const double scale : {0x1p-300, 0x1p500}) {
      std::vector<Point3> scaled = points;
      for (Point3& p : scaled) p = {p.x * scale, p.y * scale, p.z * scale};
      EXPECT_EQ(by_coordinates(scaled, scale), before);
    }
  }
}

/// Points of a sphere about the origin, evenly.
void add_sphere(double radius, int count, std::vector<Point3>& points) {
  const double golden = std::acos(-1.0) * (3 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double r = std::sqrt(1 - z * z);
    points.push_back({radius * r * std::cos(golden * i), radius * r * std::sin(golden * i), radius * z});
  }
}

double volume(const FlowMesh& mesh) {
  double six = 0;
  for (const auto& t : mesh.triangles) {
    const Point3& a = mesh.points[t[0]];
    const Point3& b = mesh.points[t[1]];
    const Point3& c = mesh.points[t[2]];
    six += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  }
  return six / 6;
}

TEST(CriticalSeparation, OfDenseSamplesNearestPointsAgree) {
  std::vector<Point3> points;
  add_sphere(1, 500, points);
  const Separated sphere(points);
  EXPECT_EQ(sphere.separation.disputed, (std::array<std::size_t, 4>{}));
  // Of a sphere what is medial is at its centre.
  const CriticalValues values(sphere.triangulation);
  for (std::size_t i = 0; i < sphere.graph.maxima().size(); ++i) {
    const Point3 at = values.near_centre(sphere.graph.maxima()[i].cell);
    const double from_centre = std::sqrt(at.x * at.x + at.y * at.y + at.z * at.z);
    EXPECT_EQ(sphere.separation.maxima[i], from_centre < 0.3) << from_centre;
  }
  const SeparatedSolid solid = sphere.solid();
  EXPECT_EQ(solid.parts, 2U);
  EXPECT_EQ(solid.unclear, 0U);
  const FlowMesh mesh = flow_mesh(sphere.cells, solid.solid.wall, context());
  EXPECT_NEAR(volume(mesh), 4.19, 0.08);
}

TEST(CriticalSeparation, HollowSolidsStayHollow) {
  std::vector<Point3> points;
  add_sphere(1, 400, points);
  add_sphere(2, 1500, points);
  add_sphere(3, 3000, points);
  const Separated shells(points);
  const SeparatedSolid solid = shells.solid();
  EXPECT_EQ(solid.parts, 4U);
  EXPECT_EQ(solid.unclear, 0U);
  const FlowMesh mesh = flow_mesh(shells.cells, solid.solid.wall, context());
  EXPECT_NEAR(volume(mesh), 4.18879 * (27 - 8 + 1), 1.5);
}

TEST(CriticalSeparation, OfAShallowBowlNothingIsInside) {
  std::vector<Point3> points;
  add_sphere(1, 600, points);
  std::erase_if(points, [](const Point3& p) { return p.z > -0.3; });
  const SeparatedSolid solid = Separated(points).solid();
  EXPECT_EQ(solid.parts, 1U);
  EXPECT_TRUE(solid.solid.wall.empty());
}

TEST(CriticalSeparation, OfAnyPointsTheSolidHasABoundary) {
  Random random(213);
  for (const testing::Cloud& cloud : testing::flow_clouds(random, 40)) {
    SCOPED_TRACE(cloud.name);
    if (Delaunay3(cloud.points, context()).dimension() < 3) continue;
    const Separated all(cloud.points);
    const SeparatedSolid found = all.solid();
    ASSERT_EQ(found.solid.is_inside.size(), all.graph.maxima().size());
    for (std::size_t i = 0; i < all.graph.saddles().size(); ++i) {
      // What medial saddles join is on one side.
      if (!all.separation.saddles[i]) continue;
      const auto is_in = [&](std::uint32_t end) { return end != all.graph.infinity() && found.solid.is_inside[end]; };
      EXPECT_EQ(is_in(all.graph.saddles()[i].ends[0]), is_in(all.graph.saddles()[i].ends[1]));
    }
  }
}

TEST(CriticalSeparation, IsCancelled) {
  const Delaunay3 triangulation(testing::lattice(5, 5, 5), context());
  const FlowCells cells(triangulation, context());
  const FlowGraph graph(cells, context());
  const Context counted({.threads = 1, .most_polls = 1'000'000});
  const CriticalSeparation found = separate(graph, counted);
  separated_solid(graph, found, counted);
  const std::uint64_t polls = counted.polls();
  EXPECT_GT(polls, 4U);
  for (std::uint64_t most = 0; most < polls; ++most) {
    const Context stopped({.threads = 1, .most_polls = most});
    EXPECT_THROW(separated_solid(graph, separate(graph, stopped), stopped), Cancelled);
  }
}

}  // namespace
}  // namespace quoin
