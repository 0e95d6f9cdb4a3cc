// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/envelope_picture.h"

#include <gtest/gtest.h>

#include <sstream>

#include "quoin/arrangement/circular/circular_envelope.h"
#include "quoin/arrangement/linear/linear_envelope.h"
#include "quoin/view/circular_picture.h"
#include "quoin/view/picture_svg.h"

namespace quoin {
namespace {

std::vector<PictureEdge> strong_edges(const PlanarPicture& picture) {
  std::vector<PictureEdge> edges;
  for (const PictureEdge& edge : picture.edges) {
    if (edge.style == EdgeStyle::strong) edges.push_back(edge);
  }
  return edges;
}

TEST(EnvelopePicture, FollowsLinesBeyondTheSheet) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  family.add_line(list, {0, 0}, {1, 1}, "rising");
  family.add_line(list, {0, 4}, {1, 3}, "falling");
  family.add_ray(list, {5, -9}, {5, -10});  // down without bound
  family.add_point(list, {1, 9});
  const LinearEnvelope envelope = lower_envelope(family, list, Context());
  const PlanarPicture picture = picture_of(family, list, envelope);
  const std::vector<PictureEdge> strong = strong_edges(picture);
  ASSERT_EQ(strong.size(), 3U);
  ASSERT_TRUE(picture.box.has_value());
  EXPECT_LT(strong.front().path.start.x, picture.box->low.x);
  EXPECT_EQ(strong.front().path.end(), (Point2{2, 2}));
  EXPECT_GT(strong.back().path.end().x, picture.box->high.x);
  EXPECT_EQ(picture.edges.size(), 6U);
  EXPECT_EQ(picture.points.size(), 2U);  // the given one, and the crossing
  std::ostringstream out;
  write_svg(out, picture);
  EXPECT_NE(out.str().find("Interval 1"), std::string::npos);
}

TEST(EnvelopePicture, CutsArcs) {
  CircularFamily family;
  PieceList<CircularFamily> list;
  family.add_circle(list, {0, 0}, 5);
  family.add_segment(list, Point2{-9, 4}, Point2{9, 4});
  EnvelopePictureOptions options;
  options.curve_name = [](CurveId curve) { return curve.index() == 0 ? "round" : "straight"; };
  const PlanarPicture picture = picture_of(family, list, upper_envelope(family, list, Context()), options);
  const std::vector<PictureEdge> strong = strong_edges(picture);
  ASSERT_EQ(strong.size(), 3U);
  ASSERT_EQ(strong[1].path.steps.size(), 1U);
  EXPECT_TRUE(strong[1].path.steps[0].is_arc());
  EXPECT_NEAR(strong[1].path.start.x, -3, 1e-12);
  EXPECT_NEAR(strong[1].path.end().y, 4, 1e-12);
  EXPECT_EQ(strong[1].text.facts[0].second, "round");
  EXPECT_EQ(strong[2].text.facts[0].second, "straight");
}

}  // namespace
}  // namespace quoin
