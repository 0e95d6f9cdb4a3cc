// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/triangulation/delaunay_location.h"
#include "quoin/triangulation/test_clouds.h"
#include "quoin/triangulation/test_flat_clouds.h"
#include "quoin/triangulation/test_power_cells.h"
#include "quoin/triangulation/voronoi.h"

namespace quoin {
namespace {

using testing::ClippedBox;
using testing::Cloud;
using testing::power;
using testing::Random;
using testing::WeightFamily;

const Context& one_thread() {
  static const Context context({.threads = 1});
  return context;
}

std::vector<double> weigh(Random& random, const std::vector<Point3>& points, const WeightFamily& family) {
  std::vector<double> weights;
  for (const Point3& p : points) weights.push_back(family.weight(random, p.x * p.x + p.y * p.y + p.z * p.z));
  return weights;
}

std::string reproduce(const std::vector<Point3>& points, const std::vector<double>& weights) {
  std::ostringstream out;
  out << std::hexfloat;
  for (std::size_t i = 0; i < points.size(); ++i)
    out << "{{" << points[i].x << ", " << points[i].y << ", " << points[i].z << "}, " << weights[i] << "}, ";
  return out.str();
}

/// Calls test(points, weights) for all families of both.
template <class Test>
void for_all_families(Random& random, std::size_t count, const Test& test) {
  for (const Cloud& cloud : testing::clouds(random, count)) {
    for (const WeightFamily& family : testing::weight_families()) {
      const std::vector<double> weights = weigh(random, cloud.points, family);
      SCOPED_TRACE(cloud.name + ", " + family.name + ": " + reproduce(cloud.points, weights));
      test(cloud.points, weights);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

Rational power_of(const Regular3& t, const RationalPoint3& x, std::uint32_t v) {
  return power(x, t.point(v), t.weight(v));
}

TEST(RegularLocation, NearestByBruteForce) {
  Random random(41);
  for_all_families(random, 24, [&](const std::vector<Point3>& points, const std::vector<double>& weights) {
    const Regular3 t(points, weights, one_thread());
    const DelaunayLocator locator(t);
    for (int round = 0; round < test_rounds(4); ++round) {
      const Point3& a = points[random() % points.size()];
      const Point3& b = points[random() % points.size()];
      const Point3 q{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2,
                     random() % 2 == 0 ? a.z / 2 + b.z / 2 : testing::unit(random)};
      std::uint32_t best = no_vertex;
      Rational least = power(exact_point(q), points[0], weights[0]);
      for (std::size_t i = 1; i < points.size(); ++i)
        least = std::min(least, power(exact_point(q), points[i], weights[i]));
      for (std::uint32_t v = 0; v < t.vertex_count() && best == no_vertex; ++v) {
        if (!t.is_hidden(v) && power_of(t, exact_point(q), v) == least) best = v;
      }
      ASSERT_EQ(locator.nearest(q), best);
    }
  });
}

TEST(RegularLocation, PowersAreComparedExactly) {
  Random random(42);
  for (int round = 0; round < test_rounds(4000); ++round) {
    const auto coordinate = [&] {
      return round % 2 == 0 ? testing::small_integer(random, 4) : testing::any_finite(random);
    };
    const auto point = [&] { return Point3{coordinate(), coordinate(), coordinate()}; };
    const Point3 p = point();
    const Point3 a = point();
    const Point3 b = point();
    const double v = coordinate();
    // About the weight that makes both powers equal.
    const double close = (power(exact_point(p), b, 0) - power(exact_point(p), a, v)).to_double();
    const double w = round % 3 == 0 || !std::isfinite(close) ? coordinate() : std::nextafter(close, round % 4 - 1.5);
    const Sign expected = sign_of(power(exact_point(p), a, v) - power(exact_point(p), b, w));
    ASSERT_EQ(compare_powers(p, a, v, b, w), to_int(expected)) << reproduce({p, a, b}, {0, v, w});
    ASSERT_EQ(compare_powers(p, b, w, a, v), -to_int(expected)) << reproduce({p, a, b}, {0, v, w});
  }
}

TEST(RegularLocation, FacesHoldThePoint) {
  Random random(43);
  for_all_families(random, 20, [&](const std::vector<Point3>& points, const std::vector<double>& weights) {
    const Regular3 t(points, weights, one_thread());
    const DelaunayLocator locator(t);
    if (t.dimension() < 3) return;
    for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
      // Hidden ones are in a face of others; all are in some.
      const DelaunayLocation found =
          locator.locate(t.point(v), static_cast<std::uint32_t>(random() % t.cells().size()));
      const auto& w = t.cells()[found.cell].vertices;
      ASSERT_NE(found.kind, DelaunayLocation::Kind::outside);
      ASSERT_TRUE(t.is_hidden(v) || found.kind == DelaunayLocation::Kind::vertex);
      for (unsigned i = 0; i < 4; ++i) {
        const auto& [a, b, c] = facet_slots[i];
        const Sign side = orientation(t.point(w[a]), t.point(w[b]), t.point(w[c]), t.point(v));
        ASSERT_EQ(side, (found.slots >> i & 1) != 0 ? Sign::positive : Sign::zero);
      }
    }
  });
  const Regular3 t(testing::lattice(2, 2, 2), std::vector<double>(8, 1), one_thread());
  EXPECT_EQ(DelaunayLocator(t).locate({0.5, 0.26, 1.5}).kind, DelaunayLocation::Kind::outside);
  EXPECT_THROW(DelaunayLocator(t).nearest({0, std::numeric_limits<double>::quiet_NaN(), 0}), InputError);
  EXPECT_THROW(DelaunayLocator(t).locate({0, std::numeric_limits<double>::infinity(), 0}), InputError);
}

TEST(RegularCirculators, StarsAreComplete) {
  Random random(44);
  for_all_families(random, 16, [&](const std::vector<Point3>& points, const std::vector<double>& weights) {
    const Regular3 t(points, weights, one_thread());
    const VertexStars stars(t);
    const auto size = static_cast<unsigned>(t.dimension()) + 1;
    for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
      ASSERT_EQ(stars.cell(v) == VertexStars::no_cell, t.is_hidden(v));
      if (t.is_hidden(v)) continue;
      std::vector<std::uint32_t> expected;
      for (std::uint32_t c = 0; c < t.cells().size(); ++c) {
        const auto& w = t.cells()[c].vertices;
        if (std::find(w.begin(), w.begin() + size, v) != w.begin() + size) expected.push_back(c);
      }
      std::vector<std::uint32_t> star = stars.star(v);
      std::sort(star.begin(), star.end());
      ASSERT_EQ(star, expected);
    }
  });
}

/// A power diagram with what it is made of.
struct Diagram {
  Regular3 triangulation;
  DeloneLabels labels;
  Voronoi3 voronoi;

  Diagram(const std::vector<Point3>& points, const std::vector<double>& weights)
      : triangulation(points, weights, one_thread()),
        labels(delone_labels(triangulation, one_thread())),
        voronoi(triangulation, labels) {}
};

bool spans_space(const std::vector<Point3>& points) {
  return Delaunay3(points, one_thread()).dimension() == 3;
}

TEST(PowerDiagram3, CornersHaveTheLeastPowers) {
  Random random(45);
  for_all_families(random, 9, [&](const std::vector<Point3>& points, const std::vector<double>& weights) {
    if (!spans_space(points) || points.size() > 24) return;
    const Diagram diagram(points, weights);
    const Regular3& t = diagram.triangulation;
    for (std::size_t c = 0; c < t.cells().size(); ++c) {
      if (t.is_ghost(c)) continue;
      const RationalPoint3 corner = diagram.voronoi.corner(c);
      const auto& w = t.cells()[c].vertices;
      const Rational least = power_of(t, corner, w[0]);
      for (std::uint32_t q = 0; q < t.vertex_count(); ++q) {
        const Rational there = power_of(t, corner, q);
        ASSERT_TRUE(std::count(w.begin(), w.end(), q) != 0 ? there == least : there >= least);
      }
    }
  });
}

TEST(PowerDiagram3, VolumesAreThoseOfTheirFacets) {
  Random random(46);
  for_all_families(random, 9, [&](const std::vector<Point3>& points, const std::vector<double>& weights) {
    if (!spans_space(points) || points.size() > 24) return;
    const Diagram diagram(points, weights);
    const Voronoi3& voronoi = diagram.voronoi;
    for (std::uint32_t v = 0; v < diagram.triangulation.vertex_count(); ++v) {
      if (diagram.triangulation.is_hidden(v)) {
        ASSERT_FALSE(voronoi.has_cell(v));
      }
      if (voronoi.is_unbounded(v)) continue;
      ASSERT_EQ(*voronoi.volume(v), voronoi.volume(v, voronoi.facets(v)));
      ASSERT_EQ(voronoi.volume(v)->sign() == Sign::positive, voronoi.has_cell(v));
      ASSERT_EQ(voronoi.facets(v).empty(), !voronoi.has_cell(v));
    }
  });
}

/// Of all points, by their definition: what of a large box has less power of them.
class BoxOfCells {
 public:
  explicit BoxOfCells(const Regular3& t) : t_(t) {
    for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
      ClippedBox cell(far_);
      for (std::uint32_t w = 0; w < t.vertex_count(); ++w) {
        if (w != v) cell.clip([&](const RationalPoint3& x) { return height(x, v, w); });
      }
      cells_.push_back(cell);
    }
  }
  Rational volume(std::uint32_t v) const { return cells_[v].volume(); }
  Rational volume_of_all() const { return Rational(8) * far_ * far_ * far_; }
  bool is_bounded(std::uint32_t v) const {
    return std::ranges::all_of(cells_[v].corners(), [this](const RationalPoint3& p) {
      return abs(p.x) < far_ && abs(p.y) < far_ && abs(p.z) < far_;
    });
  }
  /// Of the side towards another cell; nothing where they share none.
  std::vector<RationalPoint3> side(std::uint32_t v, std::uint32_t w) const {
    std::vector<RationalPoint3> corners = cells_[v].corners();
    std::erase_if(corners, [&](const RationalPoint3& x) { return height(x, v, w).sign() != Sign::zero; });
    return ClippedBox::has_area(corners) ? corners : std::vector<RationalPoint3>{};
  }

 private:
  Rational height(const RationalPoint3& x, std::uint32_t v, std::uint32_t w) const {
    return power_of(t_, x, w) - power_of(t_, x, v);
  }

  const Regular3& t_;
  const Rational far_{1000000000};
  std::vector<ClippedBox> cells_;
};

void expect_cells_of_boxes(const std::vector<Point3>& points, const std::vector<double>& weights) {
  const Diagram diagram(points, weights);
  const Voronoi3& voronoi = diagram.voronoi;
  const BoxOfCells boxes(diagram.triangulation);
  const auto count = static_cast<std::uint32_t>(diagram.triangulation.vertex_count());
  Rational sum;
  for (std::uint32_t v = 0; v < count; ++v) {
    const Rational volume = boxes.volume(v);
    ASSERT_EQ(voronoi.has_cell(v), volume.sign() == Sign::positive);
    const bool is_unbounded = volume.sign() == Sign::positive && !boxes.is_bounded(v);
    ASSERT_EQ(voronoi.is_unbounded(v), is_unbounded);
    ASSERT_EQ(voronoi.volume(v).has_value(), !is_unbounded);
    sum += is_unbounded ? volume : *voronoi.volume(v);
    std::vector<VoronoiFacet> facets = voronoi.facets(v);
    for (std::uint32_t w = 0; w < count; ++w) {
      if (w == v || !voronoi.has_cell(v) || !voronoi.has_cell(w)) continue;
      const std::vector<RationalPoint3> side = boxes.side(v, w);
      const auto found = std::ranges::find(facets, w, &VoronoiFacet::neighbour);
      ASSERT_EQ(found != facets.end(), !side.empty()) << v << " and " << w;
      if (found == facets.end()) continue;
      if (found->is_bounded) {
        ClippedBox::sort_distinct(found->corners);
        ASSERT_EQ(found->corners, side);
      }
      facets.erase(found);
    }
    ASSERT_TRUE(facets.empty());
  }
  EXPECT_EQ(sum, boxes.volume_of_all());
}

/// With weights of all families but those of any doubles, whose cells may end beyond the box.
void expect_cells_of_boxes_with_weights(Random& random, const std::vector<Point3>& points) {
  for (const WeightFamily& family : testing::weight_families()) {
    if (std::string(family.name) == "any doubles") continue;
    const std::vector<double> weights = weigh(random, points, family);
    SCOPED_TRACE(std::string(family.name) + ": " + reproduce(points, weights));
    ASSERT_NO_FATAL_FAILURE(expect_cells_of_boxes(points, weights));
  }
}

TEST(PowerDiagram3, CellsAreThoseOfHalfSpaces) {
  Random random(47);
  for (int round = 0; round < test_rounds(15); ++round) {
    const int size = 1 + static_cast<int>(random() % 4);
    std::vector<Point3> points;
    for (std::size_t i = 4 + random() % 9; i > 0; --i) {
      points.push_back({testing::small_integer(random, size), testing::small_integer(random, size),
                        testing::small_integer(random, size)});
    }
    if (!spans_space(points)) continue;
    ASSERT_NO_FATAL_FAILURE(expect_cells_of_boxes_with_weights(random, points));
  }
}

/// All of them are infinite.
TEST(PowerDiagram3, CellsOfFlatPointsAreThoseOfHalfSpaces) {
  Random random(48);
  for (int round = 0; round < test_rounds(20); ++round) {
    const testing::IntegerPlane plane(random);
    std::vector<Point3> points;
    for (std::size_t i = 1 + random() % 9; i > 0; --i)
      points.push_back(
          plane.at(testing::small_integer(random, 2), round % 3 == 0 ? 0 : testing::small_integer(random, 2)));
    ASSERT_NO_FATAL_FAILURE(expect_cells_of_boxes_with_weights(random, points));
  }
}

/// A lattice lifted so that its points lie on faces, edges and in cells of a coarse one.
TEST(PowerDiagram3, PointsInFacesOfCellsHaveNoCell) {
  const std::vector<Point3> points = testing::lattice(3, 3, 3);
  std::vector<double> weights;
  for (const Point3& p : points) {
    const double lift = std::fabs(p.x - 1);  // two half cubes
    weights.push_back(p.x * p.x + p.y * p.y + p.z * p.z - lift);
  }
  const Diagram diagram(points, weights);
  std::size_t cells = 0;
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    const Point3 p = diagram.triangulation.point(v);
    const bool is_corner = p.y != 1 && p.z != 1;
    ASSERT_EQ(diagram.voronoi.has_cell(v), is_corner);
    cells += is_corner ? 1 : 0;
    if (!is_corner) {
      EXPECT_EQ(*diagram.voronoi.volume(v), Rational(0));
      EXPECT_TRUE(diagram.voronoi.facets(v).empty());
    }
  }
  EXPECT_EQ(cells, 12U);
  EXPECT_EQ(diagram.labels.cell_count, 2U);
  const DeloneComplex complex(diagram.triangulation, one_thread());
  EXPECT_EQ(complex.facet_count(), 11U);
  EXPECT_EQ(complex.edges().size(), 20U);
  EXPECT_EQ(complex.cell(0).size(), 8U);
  const DeloneCounts counts = count_faces(diagram.triangulation, diagram.labels, one_thread());
  EXPECT_EQ(counts.faces, (std::array<std::size_t, 4>{12, 20, 11, 2}));
  expect_cells_of_boxes(points, weights);
}

struct Faces {
  std::vector<std::vector<std::uint32_t>> cells;
  std::vector<std::vector<std::uint32_t>> facets;
  std::vector<std::array<std::uint32_t, 2>> edges;
  friend bool operator==(const Faces&, const Faces&) = default;
};

template <class Triangulation>
Faces faces_of(const Triangulation& t) {
  const DeloneComplex complex(t, one_thread());
  Faces faces;
  for (std::size_t c = 0; c < complex.cell_count(); ++c)
    faces.cells.emplace_back(complex.cell(c).begin(), complex.cell(c).end());
  for (std::size_t f = 0; f < complex.facet_count(); ++f)
    faces.facets.emplace_back(complex.facet(f).begin(), complex.facet(f).end());
  faces.edges.assign(complex.edges().begin(), complex.edges().end());
  return faces;
}

TEST(RegularDelone, OfAllDimensions) {
  Random random(48);
  for_all_families(random, 18, [&](const std::vector<Point3>& points, const std::vector<double>& weights) {
    const Regular3 t(points, weights, one_thread());
    const DeloneLabels labels = delone_labels(t, one_thread());
    const Faces faces = faces_of(t);
    const DeloneCounts counts = count_faces(t, labels, one_thread());
    ASSERT_EQ(counts.faces[0], labels.corner_count(t.vertex_count()));
    ASSERT_EQ(counts.faces[static_cast<std::size_t>(t.dimension())], faces.cells.size());
    if (t.dimension() == 3) {
      ASSERT_EQ(counts.faces[2], faces.facets.size());
    }
    if (t.dimension() > 1) {
      ASSERT_EQ(counts.faces[1], faces.edges.size());
    }
    // Corners are what the cells have, and no cell has a vertex that is not.
    std::set<std::uint32_t> used;
    for (const auto& cell : faces.cells) {
      ASSERT_GT(cell.size(), static_cast<std::size_t>(t.dimension()));
      used.insert(cell.begin(), cell.end());
    }
    for (std::uint32_t v = 0; v < t.vertex_count(); ++v) ASSERT_EQ(used.count(v) != 0, labels.is_corner(v));
    for (const auto& facet : faces.facets) {
      ASSERT_GE(facet.size(), static_cast<std::size_t>(t.dimension()));
      for (const std::uint32_t v : facet) ASSERT_TRUE(labels.is_corner(v));
    }
  });
}

TEST(RegularDelone, EqualWeightsAndTheirChangesDoNotMatter) {
  Random random(49);
  for (const Cloud& cloud : testing::clouds(random, 30)) {
    SCOPED_TRACE(cloud.name);
    const Faces expected = faces_of(Delaunay3(cloud.points, one_thread()));
    for (const double weight : {0.0, -7.25, 1e300}) {
      const std::vector<double> weights(cloud.points.size(), weight);
      ASSERT_EQ(faces_of(Regular3(cloud.points, weights, one_thread())), expected);
    }
  }
}

std::vector<std::vector<VoronoiFacet>> facets_of(const Diagram& diagram) {
  std::vector<std::vector<VoronoiFacet>> all;
  for (std::uint32_t v = 0; v < diagram.triangulation.vertex_count(); ++v) all.push_back(diagram.voronoi.facets(v));
  return all;
}

void expect_same_facets(const std::vector<VoronoiFacet>& a, const std::vector<VoronoiFacet>& b, double scale = 1) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].neighbour, b[i].neighbour);
    ASSERT_EQ(a[i].is_bounded, b[i].is_bounded);
    ASSERT_EQ(a[i].corners.size(), b[i].corners.size());
    // A ring that is bounded may begin anywhere.
    std::vector<RationalPoint3> p;
    for (const RationalPoint3& corner : a[i].corners) p.push_back(corner * Rational(scale));
    std::vector<RationalPoint3> q = b[i].corners;
    if (a[i].is_bounded) {
      const auto first = std::ranges::find(q, p[0]);
      ASSERT_NE(first, q.end());
      std::rotate(q.begin(), first, q.end());
    }
    ASSERT_EQ(p, q);
  }
}

TEST(PowerDiagram3, EqualWeightsGiveVoronoiDiagrams) {
  Random random(50);
  for (const Cloud& cloud : testing::clouds(random, 16)) {
    if (!spans_space(cloud.points)) continue;
    SCOPED_TRACE(cloud.name);
    const Delaunay3 t(cloud.points, one_thread());
    const Voronoi3 expected(t);
    const Diagram diagram(cloud.points, std::vector<double>(cloud.points.size(), 0.75));
    for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
      ASSERT_TRUE(diagram.voronoi.has_cell(v));
      ASSERT_EQ(diagram.voronoi.is_unbounded(v), expected.is_unbounded(v));
      ASSERT_EQ(diagram.voronoi.volume(v), expected.volume(v));
      expect_same_facets(diagram.voronoi.facets(v), expected.facets(v));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(PowerDiagram3, ConstantsOrderAndScaleDoNotMatter) {
  Random random(51);
  for (int round = 0; round < test_rounds(30); ++round) {
    std::vector<Point3> points =
        testing::random_points(random, 16, [](Random& r) { return testing::small_integer(r, 3); });
    if (!spans_space(points)) continue;
    const WeightFamily& family = testing::weight_families()[2 + static_cast<std::size_t>(round) % 5];
    std::vector<double> weights = weigh(random, points, family);
    for (double& w : weights) w = std::round(w * 8);
    SCOPED_TRACE(reproduce(points, weights));
    const auto expected = facets_of(Diagram(points, weights));
    const auto expect_same = [&](double scale) {
      const auto facets = facets_of(Diagram(points, weights));
      ASSERT_EQ(facets.size(), expected.size());
      for (std::size_t v = 0; v < facets.size(); ++v) expect_same_facets(expected[v], facets[v], scale);
    };
    for (double& w : weights) w += 1024;
    expect_same(1);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), random);
    const std::vector<Point3> old_points = points;
    const std::vector<double> old_weights = weights;
    for (std::size_t i = 0; i < order.size(); ++i) {
      points[i] = old_points[order[i]];
      weights[i] = old_weights[order[i]];
    }
    expect_same(1);
    for (Point3& p : points) p = {p.x * 0x1p-40, p.y * 0x1p-40, p.z * 0x1p-40};
    for (double& w : weights) w *= 0x1p-80;
    expect_same(0x1p-40);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace quoin
