// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/cube_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "quoin/base/test_rounds.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/polytope.h"
#include "quoin/view/picture_svg.h"

namespace quoin {
namespace {

const Context one_thread({.threads = 1});

/// The direction that a point of the cross stands for: z up on the row, x to the right in the middle.
Vector3 direction_at(const Point2& p) {
  if (p.y > 1) return {p.x, p.y - 2, 1};
  if (p.y < -1) return {p.x, -(p.y + 2), -1};
  if (p.x < -1) return {-1, -(p.x + 2), p.y};
  if (p.x < 1) return {p.x, -1, p.y};
  if (p.x < 3) return {1, p.x - 2, p.y};
  return {-(p.x - 4), 1, p.y};
}

std::uint32_t extreme(const Polytope& p, const Vector3& d) {
  std::uint32_t best = 0;
  const auto height = [&](std::uint32_t v) { return p.vertex(v).x * d.x + p.vertex(v).y * d.y + p.vertex(v).z * d.z; };
  for (std::uint32_t v = 1; v < p.vertex_count(); ++v) {
    if (height(v) > height(best)) best = v;
  }
  return best;
}

double area(const PicturePath& ring) {
  double sum = 0;
  Point2 from = ring.start;
  for (const PathStep& step : ring.steps) {
    sum += from.x * step.to.y - from.y * step.to.x;
    from = step.to;
  }
  return (sum + from.x * ring.start.y - from.y * ring.start.x) / 2;
}

Point2 middle(const PicturePath& ring) {
  Point2 sum;
  double count = 0;
  for (const PathStep& step : ring.steps) {
    sum = {sum.x + step.to.x, sum.y + step.to.y};
    ++count;
  }
  return {sum.x / count, sum.y / count};
}

TEST(CubePicture, FacesAreTheDirectionsOfTheirVertices) {
  for (std::uint64_t seed = 0; seed < test_rounds(40U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::vector<Point3> points;
    for (std::uint64_t i = 4 + random() % 20; i > 0; --i) {
      const auto draw = [&] { return static_cast<double>(random() % 7); };
      const double x = draw();
      const double y = draw();
      points.push_back({x, y, draw()});
    }
    if (convex_hull(points, one_thread).dimension < 3) continue;
    const Polytope p = Polytope::hull_of(points, one_thread);
    const CubicalMap map = cubical_map(p, one_thread);
    const PlanarPicture picture = cube_picture_of(map);
    check_picture(picture);
    ASSERT_EQ(picture.faces.size(), map.counts().faces - 6);
    double whole = 0;
    for (const PictureFace& face : picture.faces) {
      ASSERT_EQ(face.rings.size(), 1U);
      EXPECT_GT(area(face.rings[0]), 0) << "counterclockwise from outside";
      whole += area(face.rings[0]);
      ASSERT_EQ(face.fill.category, extreme(p, direction_at(middle(face.rings[0]))));
    }
    EXPECT_NEAR(whole, 24, 1e-9);
  }
}

/// Five of twelve edges of the cube are seams of the cross.
TEST(CubePicture, DrawsSeamsOnce) {
  const std::vector<Point3> octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const PlanarPicture picture =
      cube_picture_of(cubical_map(Polytope::hull_of(octahedron, one_thread), one_thread), {.title = "Cross"});
  EXPECT_EQ(picture.edges.size(), 2 * 12U - 5U);
  for (const PictureEdge& edge : picture.edges) EXPECT_EQ(edge.style, EdgeStyle::strong);
  EXPECT_EQ(picture.points.size(), 14U + 6U) << "corners of the cross, and names of squares";
  std::ostringstream svg;
  write_svg(svg, picture);
  for (const char* name : {"x = -1", "y = -1", "z = -1", "x = 1", "y = 1", "z = 1"}) {
    EXPECT_NE(svg.str().find(std::string(">") + name + "</text>"), std::string::npos) << name;
  }
}

TEST(CubePicture, TellsRealFromArtificial) {
  std::vector<Point3> cube;
  for (int i = 0; i < 8; ++i) cube.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
  const CubicalMap map = cubical_map(Polytope::hull_of(cube, one_thread), one_thread);
  const PlanarPicture picture = cube_picture_of(map, {.vertex_name = {}, .has_labels = true});
  const auto count = [&](EdgeStyle style) {
    return std::count_if(picture.edges.begin(), picture.edges.end(),
                         [&](const PictureEdge& edge) { return edge.style == style; });
  };
  EXPECT_EQ(count(EdgeStyle::strong), 24) << "four arms on each square";
  EXPECT_EQ(count(EdgeStyle::faint), 2 * 19) << "halves of sides";
  EXPECT_EQ(picture.faces[0].text.label, std::to_string(*picture.faces[0].fill.category));
}

}  // namespace
}  // namespace quoin
