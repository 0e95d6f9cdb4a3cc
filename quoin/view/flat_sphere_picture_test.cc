// SPDX-License-Identifier: Apache-2.0
//
// Flat pictures of the sphere: every point is in the ring of the face that exact location finds there.
#include "quoin/view/flat_sphere_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "quoin/arrangement/geodesic/geodesic_location.h"
#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/view/picture_svg.h"

namespace quoin {
namespace {

using Random = std::mt19937_64;

Vector3 small_vector(Random& random) {
  const auto draw = [&] { return static_cast<double>(random() % 5) - 2; };
  Vector3 v{draw(), draw(), draw()};
  return v == Vector3{} ? Vector3{-1, 0, 0} : v;
}

/// Whole circles, arcs and points, often through poles and along the half meridian where longitude jumps.
void add_curves(GeodesicFamily& family, PieceList<GeodesicFamily>& list, Random& random) {
  for (std::uint64_t i = random() % 7; i > 0; --i) {
    const SphereDirection a(small_vector(random));
    const SphereDirection b(small_vector(random));
    const auto kind = random() % 4;
    if (kind == 0) {
      family.add_great_circle(list, a);
    } else if (kind == 1) {
      family.add_point(list, a);
    } else if (cross(a, b).is_valid()) {
      family.add_arc(list, a, b);
    }
  }
}

struct Sample {
  Point2 at;
  Vector3 direction;
};

std::vector<Sample> samples_of_the_rectangle() {
  std::vector<Sample> samples;
  for (double x = -178.7; x < 180; x += 11.9) {
    for (double y = -88.9; y < 90; y += 7.7) {
      const double u = x * std::numbers::pi / 180;
      const double v = y * std::numbers::pi / 180;
      samples.push_back({{x, y}, {std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)}});
    }
  }
  return samples;
}

bool is_inside(const PictureFace& face, const Point2& p) {
  bool inside = false;
  for (const PicturePath& ring : face.rings) {
    const std::vector<Point2> polygon = flattened(ring, 0.01);
    for (std::size_t i = 0, k = polygon.size() - 1; i < polygon.size(); k = i++) {
      const Point2& a = polygon[k];
      const Point2& b = polygon[i];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
  }
  return inside;
}

double distance_to(const PicturePath& path, const Point2& p) {
  double least = std::hypot(path.start.x - p.x, path.start.y - p.y);
  Point2 from = path.start;
  for (const PathStep& step : path.steps) {
    const double dx = step.to.x - from.x;
    const double dy = step.to.y - from.y;
    const double length = dx * dx + dy * dy;
    const double t = length > 0 ? std::clamp(((p.x - from.x) * dx + (p.y - from.y) * dy) / length, 0.0, 1.0) : 0.0;
    least = std::min(least, std::hypot(from.x + t * dx - p.x, from.y + t * dy - p.y));
    from = step.to;
  }
  return least;
}

double twice_area(const PicturePath& ring) {
  double sum = 0;
  Point2 from = ring.start;
  const auto add = [&](const Point2& to) {
    sum += from.x * to.y - from.y * to.x;
    from = to;
  };
  for (const PathStep& step : ring.steps) add(step.to);
  add(ring.start);
  return sum;
}

TEST(FlatSpherePicture, FacesAreWhereExactLocationFindsThem) {
  const std::vector<Sample> samples = samples_of_the_rectangle();
  for (std::uint64_t seed = 0; seed < test_rounds(40U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    GeodesicFamily family;
    PieceList<GeodesicFamily> list;
    add_curves(family, list, random);
    std::vector<GeodesicFamily::Point> queries;
    for (const Sample& sample : samples) queries.push_back(family.make_point(SphereDirection(sample.direction)));
    const GeodesicArrangement a = arrange(std::move(family), std::move(list), Context());
    const std::vector<Location> found = locate_batch(a, queries, Context());
    const PlanarPicture picture = flat_picture_of(a, {}, Context());
    check_picture(picture);
    ASSERT_EQ(picture.faces.size(), a.counts().faces);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const bool is_near = std::any_of(picture.edges.begin(), picture.edges.end(), [&](const PictureEdge& edge) {
        return distance_to(edge.path, samples[i].at) < 0.2;
      });
      if (is_near || found[i].kind() != Location::Kind::face) continue;
      for (std::size_t f = 0; f < picture.faces.size(); ++f) {
        ASSERT_EQ(is_inside(picture.faces[f], samples[i].at), f == found[i].face().index())
            << "face " << f << " at " << samples[i].at.x << ", " << samples[i].at.y;
      }
    }
    double area = 0;
    for (const PictureFace& face : picture.faces) {
      for (const PicturePath& ring : face.rings) area += twice_area(ring) / 2;
    }
    EXPECT_NEAR(area, 360.0 * 180.0, 1e-6);
  }
}

GeodesicArrangement arrangement_of(const std::vector<std::pair<Vector3, Vector3>>& arcs) {
  GeodesicFamily family;
  PieceList<GeodesicFamily> list;
  for (const auto& [a, b] : arcs) family.add_arc(list, SphereDirection(a), SphereDirection(b));
  return arrange(std::move(family), std::move(list), Context());
}

TEST(FlatSpherePicture, DrawsTwiceWhatIsOnTheCut) {
  const PlanarPicture picture = flat_picture_of(arrangement_of({{{-1, 0, 0}, {-1, 0, 1}}}), {}, Context());
  ASSERT_EQ(picture.edges.size(), 3U) << "the border, and an edge on both sides";
  EXPECT_EQ(picture.edges[1].path.start.x, -180);
  EXPECT_EQ(picture.edges[2].path.start.x, 180);
  EXPECT_EQ(picture.points.size(), 4U);
  EXPECT_EQ(picture.faces.size(), 1U);
}

TEST(FlatSpherePicture, APoleIsABorder) {
  const PlanarPicture picture = flat_picture_of(arrangement_of({{{1, 1, 0}, {0, 0, 1}}}), {}, Context());
  ASSERT_EQ(picture.edges.size(), 3U);
  EXPECT_EQ(picture.edges[1].path.end().y, 90);
  EXPECT_NEAR(picture.edges[1].path.end().x, 45, 1e-9);
  EXPECT_EQ(picture.edges[2].path.start.x, -180);
  EXPECT_EQ(picture.edges[2].path.end().x, 180);
  EXPECT_EQ(picture.edges[2].text.name, "Vertex 1");
  EXPECT_EQ(picture.points.size(), 1U);
}

/// An arc that passes a pole within a thousandth of a degree turns quickly there.
TEST(FlatSpherePicture, StepsAreNarrowNearPoles) {
  const PlanarPicture picture = flat_picture_of(arrangement_of({{{1, 1e-5, 1}, {-1, 1e-5, 1}}}), {}, Context());
  const PicturePath& path = picture.edges[1].path;
  Point2 from = path.start;
  for (const PathStep& step : path.steps) {
    EXPECT_LE(std::fabs(step.to.x - from.x), 2.0);
    from = step.to;
  }
  EXPECT_GT(path.steps.size(), 90U);
}

TEST(FlatSpherePicture, OfNothingIsOneFace) {
  const PlanarPicture picture = flat_picture_of(arrangement_of({}), {}, Context());
  ASSERT_EQ(picture.faces.size(), 1U);
  ASSERT_EQ(picture.faces[0].rings.size(), 1U);
  EXPECT_NEAR(twice_area(picture.faces[0].rings[0]), 2 * 360.0 * 180.0, 1e-9);
}

TEST(FlatSpherePicture, CanBeCancelled) {
  Context context;
  context.cancel();
  EXPECT_THROW(flat_picture_of(arrangement_of({{{1, 0, 0}, {0, 1, 0}}}), {}, context), Cancelled);
}

}  // namespace
}  // namespace quoin
