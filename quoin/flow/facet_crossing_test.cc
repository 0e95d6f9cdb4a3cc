// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/facet_crossing.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>

#include "quoin/base/test_rounds.h"
#include "quoin/flow/facet_formulas.h"
#include "quoin/flow/test_flow.h"
#include "quoin/flow/test_scans.h"

namespace quoin {
namespace {

using testing::flow_complex;
using testing::Random;

/// A crossing of a facet by signs along its boundary, as the paper does it: the boundary as Voronoi vertices or, at its
/// ends, directions of rays; where the sign against the line from the midpoint changes, the line leaves.
class SignScan {
 public:
  SignScan(const FlowComplex& flow, std::uint32_t edge, std::uint32_t polygon, const RationalPoint3& at)
      : flow_(flow), faces_(flow.faces()), edge_(edge), middle_(flow.centre({1, edge})), to_(at - middle_) {
    const std::array<std::uint32_t, 2> ends = faces_.edge(edge);
    along_ = exact_point(flow.point(ends[1])) - exact_point(flow.point(ends[0]));
    found_ = walk(polygon, 1);
    if (!found_) found_ = walk(polygon, 0);
  }
  /// A polygon or a cell; nothing at infinity.
  const std::optional<DeloneFace>& found() const { return found_; }

 private:
  Sign sign(const RationalPoint3& v) const { return dot(cross(to_, v), along_).sign(); }
  RationalPoint3 outwards(std::uint32_t polygon, std::size_t side) const {
    const flow::Vector<Rational> n = flow::normal<Rational>(flow_, polygon);
    const RationalPoint3 up{n.x, n.y, n.z};
    return side == 1 ? up : RationalPoint3{} - up;
  }

  /// From one end of the polygon's Voronoi edge on, to where the boundary comes back or goes to infinity.
  std::optional<DeloneFace> walk(std::uint32_t start, std::size_t side) const {
    std::optional<Sign> first;
    std::uint32_t polygon = start;
    while (true) {
      const std::uint32_t cell = faces_.cells_of_polygon(polygon)[side];
      const bool is_ray = cell == DeloneFaces::outside;
      const Sign here = sign(is_ray ? outwards(polygon, side) : flow_.centre({3, cell}) - middle_);
      if (!first) {
        first = here;
      } else if (here == Sign::zero && !is_ray) {
        return DeloneFace{3, cell};
      } else if (here == -*first && here != Sign::zero) {
        return DeloneFace{2, polygon};
      }
      if (is_ray) return std::nullopt;
      const std::array<std::uint32_t, 2> pair = faces_.polygons_at_edge(cell, edge_);
      polygon = pair[0] == polygon ? pair[1] : pair[0];
      if (polygon == start) return std::nullopt;
      side = faces_.cells_of_polygon(polygon)[0] == cell ? 1 : 0;
    }
  }

  const FlowComplex& flow_;
  const DeloneFaces& faces_;
  std::uint32_t edge_;
  RationalPoint3 middle_;
  RationalPoint3 to_;
  RationalPoint3 along_;
  std::optional<DeloneFace> found_;
};

/// A polygon from whose Voronoi edge the flow goes on through the facet of an edge, and that Voronoi edge.
struct Entry {
  std::uint32_t polygon;
  std::uint32_t edge;
  RationalPoint3 centre;
  RationalPoint3 normal;
  std::array<std::optional<Rational>, 2> ends;  ///< nothing at infinity

  Entry(const FlowComplex& flow, std::uint32_t f)
      : polygon(f), edge(flow.crossed({2, f}).index), centre(flow.centre({2, f})) {
    const flow::Vector<Rational> n = flow::normal<Rational>(flow, f);
    normal = {n.x, n.y, n.z};
    for (std::size_t side = 0; side < 2; ++side) {
      const std::uint32_t cell = flow.faces().cells_of_polygon(f)[side];
      if (cell == DeloneFaces::outside) continue;
      ends[side] = dot(flow.centre({3, cell}) - centre, normal) / dot(normal, normal);
    }
  }
  RationalPoint3 at(const Rational& t) const { return centre + normal * t; }
  bool has(const Rational& t) const { return (!ends[0] || *ends[0] < t) && (!ends[1] || t < *ends[1]); }
  /// Its middle, or a place on a ray.
  Rational middle() const {
    if (ends[0] && ends[1]) return (*ends[0] + *ends[1]) * (Rational(1) / Rational(2));
    return ends[0] ? *ends[0] + Rational(1) : *ends[1] - Rational(1);
  }
};

void check_crossing(const FlowComplex& flow, const Entry& entry, const Rational& t,
                    std::map<FacetExit::Kind, std::size_t>& seen) {
  FlowPoints points(flow);
  const RationalPoint3 at = entry.at(t);
  const FacetExit exit = cross_forward(points, points.add_place(at, {2, entry.polygon}), entry.edge);
  const SignScan scan(flow, entry.edge, entry.polygon, at);
  ++seen[exit.kind];
  ASSERT_EQ(exit.kind != FacetExit::Kind::infinity, scan.found().has_value());
  if (!scan.found()) return;
  ASSERT_EQ(points.face(exit.point), *scan.found());
  // Beyond the start, as seen from the midpoint, on a line with it.
  const RationalPoint3 from = at - flow.centre({1, entry.edge});
  const RationalPoint3 off = points.exact(exit.point) - at;
  ASSERT_EQ(cross(off, from), RationalPoint3{});
  ASSERT_EQ(dot(off, from).sign(), Sign::positive);
}

/// From the middle of each Voronoi edge, and from where Voronoi vertices of the facet are just behind.
void check_crossings(const FlowComplex& flow, std::map<FacetExit::Kind, std::size_t>& seen) {
  const DeloneFaces& faces = flow.faces();
  const auto step = static_cast<std::uint32_t>(1 + faces.count(2) / 40);
  for (std::uint32_t f = 0; f < faces.count(2); f += step) {
    if (flow.crossed({2, f}).dimension != 1) continue;
    const Entry entry(flow, f);
    ASSERT_NO_FATAL_FAILURE(check_crossing(flow, entry, entry.middle(), seen));
    const flow::FacetLine<Rational> line(flow, entry.edge, faces.apex(f, faces.side_of(f, entry.edge)));
    const flow::Vector<Rational> normal = flow::normal<Rational>(flow, f);
    for (const RingPolygon& g : faces.ring(entry.edge)) {
      const std::uint32_t cell = faces.cells_of_polygon(g.polygon)[0];
      if (cell == DeloneFaces::outside) continue;
      const RationalPoint3 to = flow.centre({3, cell}) - flow.centre({1, entry.edge});
      const flow::Vector<Rational> y{to.x, to.y, to.z};
      if (dot(y, line.direction).sign() != Sign::negative) continue;
      const Rational t = flow::landing(line, normal, y);
      if (!entry.has(t)) continue;
      ASSERT_NO_FATAL_FAILURE(check_crossing(flow, entry, t, seen));
    }
  }
}

TEST(FacetCrossing, IsWhereSignsChange) {
  Random random(164);
  std::map<FacetExit::Kind, std::size_t> seen;
  for (const testing::Cloud& cloud : testing::flow_clouds(random, 10)) {
    SCOPED_TRACE(cloud.name);
    const FlowComplex flow = flow_complex(cloud.points);
    if (flow.faces().dimension() < 3) continue;
    ASSERT_NO_FATAL_FAILURE(check_crossings(flow, seen));
  }
  for (int round = 0; round < test_rounds(20); ++round) {
    const FlowComplex flow =
        flow_complex(testing::random_points(random, 12, [](Random& r) { return testing::small_integer(r, 4); }));
    if (flow.faces().dimension() < 3) continue;
    ASSERT_NO_FATAL_FAILURE(check_crossings(flow, seen));
  }
  EXPECT_GT(seen[FacetExit::Kind::edge], 50U);
  EXPECT_GT(seen[FacetExit::Kind::infinity], 50U);
  EXPECT_GT(seen[FacetExit::Kind::vertex], 50U);
}

}  // namespace
}  // namespace quoin
