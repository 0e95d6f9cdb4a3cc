// SPDX-License-Identifier: Apache-2.0
// Point sets bounded by arcs, in the plane and on the sphere.
#include <gtest/gtest.h>

#include <vector>

#include "quoin/arrangement/circular/circular_polygon_set.h"
#include "quoin/arrangement/geodesic/geodesic_polygon_set.h"

namespace quoin {
namespace {

/// The half of the unit disc above the x-axis, or below.
CircularPolygonSet half_disc(bool upper) {
  CircularFamily family;
  PieceList<CircularFamily> list;
  const double from = upper ? 1 : -1;
  family.add_arc(list, Point2{0, 0}, 1, Point2{from, 0}, Point2{-from, 0}, CircularFamily::Direction::counterclockwise);
  family.add_segment(list, Point2{-from, 0}, Point2{from, 0});
  return combine_rings(std::move(family), list, std::vector<std::uint32_t>(list.curve_count, 0), 1, FillRule::nonzero,
                       SetOperation::unite, Context());
}

// Book on arrangements, 3.6: the diameter goes, the circle stays as two x-monotone arcs.
TEST(CurvedPolygonSet, UnionOfHalfDiscsLosesItsDiameter) {
  const CircularPolygonSet upper = half_disc(true);
  const CircularPolygonSet lower = half_disc(false);
  const std::vector<const CircularPolygonSet*> both{&upper, &lower};
  const auto disc = combine<CircularFamily>(both, SetOperation::unite, Regularity::regularized, Context());
  const dcel::Counts counts = disc.arrangement().counts();
  EXPECT_EQ(counts.vertices, 2U);
  EXPECT_EQ(counts.edges, 2U);
  EXPECT_EQ(counts.faces, 2U);
  EXPECT_TRUE(combine<CircularFamily>(both, SetOperation::intersect, Regularity::regularized, Context()).is_empty());
  const auto diameter = combine<CircularFamily>(both, SetOperation::intersect, Regularity::plain, Context());
  EXPECT_EQ(diameter.arrangement().counts().edges, 1U);
  EXPECT_EQ(diameter.arrangement().counts().faces, 1U);
}

/// The directions with a x + b y + c z >= 0 for each normal.
GeodesicPolygonSet half_spheres(const std::vector<Vector3>& normals) {
  std::vector<GeodesicPolygonSet> sets;
  for (const Vector3& normal : normals) {
    GeodesicFamily family;
    PieceList<GeodesicFamily> list;
    family.add_great_circle(list, normal);
    // A circle winds around its left side, which holds the base face or not: by the rule, one side or the other.
    GeodesicArrangement circle = arrange(std::move(family), std::move(list), Context());
    std::vector<bool> faces(circle.face_count(), false);
    for (std::size_t e = 0; e < circle.edge_count(); ++e) {
      const dcel::EdgeId edge(e);
      const bool above_is_left = !circle.curves(edge)[0].is_reversed();
      faces[circle.cells().face(dcel::HalfedgeId(edge, !above_is_left)).index()] = true;
    }
    sets.emplace_back(circle, std::vector<bool>(circle.vertex_count(), true),
                      std::vector<bool>(circle.edge_count(), true), faces);
  }
  std::vector<const GeodesicPolygonSet*> pointers;
  for (const GeodesicPolygonSet& set : sets) pointers.push_back(&set);
  return combine<GeodesicFamily>(pointers, SetOperation::intersect, Regularity::plain, Context());
}

TEST(CurvedPolygonSet, OctantsOfTheSphere) {
  for (int octant = 0; octant < 8; ++octant) {
    const double x = (octant & 1) != 0 ? 1 : -1;
    const double y = (octant & 2) != 0 ? 1 : -1;
    const double z = (octant & 4) != 0 ? 1 : -1;
    const GeodesicPolygonSet set = half_spheres({{x, 0, 0}, {0, y, 0}, {0, 0, z}});
    dcel::check_links(set.arrangement().cells());
    EXPECT_EQ(set.arrangement().counts().vertices, 3U) << octant;
    EXPECT_EQ(set.arrangement().counts().edges, 3U) << octant;
    EXPECT_EQ(set.arrangement().counts().faces, 2U) << octant;
    EXPECT_TRUE(set.is_regular());
  }
}

TEST(CurvedPolygonSet, WedgesOnTheSphereShrinkToPointsAndArcs) {
  // Opposite half spheres share a great circle; with a third one half of it, with a fourth a point.
  const GeodesicPolygonSet circle = half_spheres({{1, 2, 3}, {-1, -2, -3}});
  EXPECT_EQ(circle.arrangement().counts().faces, 2U);
  EXPECT_TRUE(circle.regularized().is_empty());
  EXPECT_FALSE(circle.is_empty());
  const GeodesicPolygonSet arc = half_spheres({{1, 2, 3}, {-1, -2, -3}, {2, -1, 0}});
  EXPECT_EQ(arc.arrangement().counts().faces, 1U);
  const GeodesicPolygonSet points = half_spheres({{1, 2, 3}, {-1, -2, -3}, {2, -1, 0}, {-2, 1, 0}});
  EXPECT_EQ(points.arrangement().counts().isolated_vertices, 2U);
  EXPECT_EQ(points.arrangement().counts().edges, 0U);
  const GeodesicPolygonSet point = half_spheres({{1, 2, 3}, {-1, -2, -3}, {2, -1, 0}, {-2, 1, 0}, {-3, -6, 5}});
  EXPECT_EQ(point.arrangement().counts().isolated_vertices, 1U);
}

TEST(CurvedPolygonSet, TheSphereMayBeFullOrEmpty) {
  const GeodesicPolygonSet empty;
  EXPECT_TRUE(empty.is_empty());
  EXPECT_TRUE(empty.complement().is_everything());
  const GeodesicPolygonSet half = half_spheres({{3, -1, 2}});
  const GeodesicPolygonSet other = half.complement();
  const std::vector<const GeodesicPolygonSet*> both{&half, &other};
  EXPECT_TRUE(combine<GeodesicFamily>(both, SetOperation::unite, Regularity::plain, Context()).is_everything());
  EXPECT_TRUE(combine<GeodesicFamily>(both, SetOperation::intersect, Regularity::plain, Context()).is_empty());
}

}  // namespace
}  // namespace quoin
