// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/picture_svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "quoin/base/error.h"
#include "quoin/view/picture_labels.h"
#include "quoin/view/picture_path.h"

namespace quoin {
namespace {

std::string svg_of(const PlanarPicture& picture, const SvgOptions& options = {}) {
  std::ostringstream out;
  write_svg(out, picture, options);
  return out.str();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Elements are nested and closed, attributes quoted, and text holds no markup: enough XML for what is written here.
void expect_well_formed(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find('>', at);
    ASSERT_NE(end, std::string::npos);
    std::string tag = text.substr(at + 1, end - at - 1);
    ASSERT_EQ(tag.find('<'), std::string::npos) << tag;
    ASSERT_EQ(count(tag, "\"") % 2, 0U) << tag;
    const std::string name = tag.substr(0, tag.find_first_of(" />", 1));
    if (tag.front() == '/') {
      ASSERT_FALSE(open.empty()) << tag;
      ASSERT_EQ("/" + open.back(), name) << tag;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
  }
  EXPECT_TRUE(open.empty());
  for (std::size_t at = text.find('&'); at != std::string::npos; at = text.find('&', at + 1)) {
    const std::string entity = text.substr(at, text.find(';', at) - at);
    EXPECT_TRUE(entity == "&lt" || entity == "&gt" || entity == "&amp" || entity == "&quot") << entity;
  }
}

PlanarPicture ring_and_disc() {
  PlanarPicture picture;
  picture.title = "Ring & disc";
  picture.categories = {"ring", "disc"};
  picture.faces.push_back({{circle_path({0, 0}, 3), circle_path({1, 0}, 1)}, false, {0U, {}}, {"Face 0", "ring", {}}});
  picture.faces.push_back({{circle_path({1, 0}, 1)}, false, {1U, {}}, {"Face 1", "disc", {{"Kind", "bounded"}}}});
  picture.edges.push_back({circle_path({0, 0}, 3), EdgeStyle::strong, {1U, {}}, {"Edge 0", "", {}}});
  picture.edges.push_back({circle_path({1, 0}, 1), EdgeStyle::dashed, {}, {}});
  picture.points.push_back({{0, 3}, 1, {{}, Color{255, 0, 16, 128}}, {"Point", "P", {}}});
  return picture;
}

TEST(PictureSvg, HasOneElementForEachCell) {
  const std::string svg = svg_of(ring_and_disc());
  expect_well_formed(svg);
  EXPECT_EQ(count(svg, "<path"), 4U);
  EXPECT_EQ(count(svg, "<circle"), 1U);
  EXPECT_EQ(count(svg, "<text"), 5U) << "two faces, a point, two lines of the legend";
  EXPECT_EQ(count(svg, "Z\""), 2U) << "faces are closed, edges are not";
  EXPECT_NE(svg.find("class=\"strong c1\""), std::string::npos);
  EXPECT_NE(svg.find("fill:#ff0010;fill-opacity:0.5"), std::string::npos);
  EXPECT_NE(svg.find("<title>Face 1\nKind: bounded</title>"), std::string::npos);
  EXPECT_NE(svg.find("<title>Ring &amp; disc</title>"), std::string::npos);
  EXPECT_EQ(svg, svg_of(ring_and_disc())) << "the same bytes";
}

TEST(PictureSvg, DrawsArcsAsArcsAndTurnsYUpward) {
  PlanarPicture picture;
  picture.box = PictureBox{{-1, -1}, {1, 1}};
  const double third = 2 * std::numbers::pi / 3;
  picture.edges.push_back({{{1, 0}, {arc_to({std::cos(third), std::sin(third)}, {0, 0}, third)}}, {}, {}, {}});
  const std::string svg = svg_of(picture, {.size = 200});
  EXPECT_NE(svg.find("d=\"M200 100A100 100 0 0 0 50 13.4\""), std::string::npos) << svg;
}

TEST(PictureSvg, CutsWhatReachesFarAndKeepsTheRest) {
  PlanarPicture picture;
  picture.box = PictureBox{{0, 0}, {1, 1}};
  picture.edges.push_back({path_of({{-1e12, 0.5}, {1e12, 0.5}}), {}, {}, {}});
  picture.edges.push_back({path_of({{5, 5}, {6, 7}}), {}, {}, {}});
  const double radius = 1e9;  // seems straight: through (0, 0.25) and (1, 0.25)
  picture.edges.push_back({circle_path({0.5, 0.25 - radius}, radius), {}, {}, {}});
  picture.faces.push_back({{path_of({{-1e9, -1e9}, {1e9, -1e9}, {1e9, 1e9}, {-1e9, 1e9}})}, false, {0U, {}}, {}});
  picture.faces.push_back({{}, true, {1U, {}}, {}});
  const std::string svg = svg_of(picture, {.size = 100});
  expect_well_formed(svg);
  EXPECT_NE(svg.find("d=\"M-9 50L109 50\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("d=\"\""), std::string::npos) << "unseen, but its element is there";
  EXPECT_EQ(svg.find("e+"), std::string::npos) << "no large numbers";
  std::size_t arc = svg.find("<path", svg.find("d=\"\""));
  const std::string chords = svg.substr(arc, svg.find('>', arc) - arc);
  EXPECT_NE(chords.find("75L"), std::string::npos) << chords;
  EXPECT_EQ(chords.find('A'), std::string::npos) << chords;
}

TEST(PictureSvg, TextsCannotBreakOut) {
  const std::string evil = "</title><script>alert(1)</script>&\"'\x01\xFF\xED\xA0\x80 ü≈\xF0\x9F\x98\x80";
  PlanarPicture picture = ring_and_disc();
  picture.title = evil;
  picture.faces[0].text = {evil, evil, {{evil, evil}}};
  picture.points[0].text = {evil, evil, {}};
  picture.categories[0] = evil;
  const std::string svg = svg_of(picture);
  expect_well_formed(svg);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find('\x01'), std::string::npos);
  EXPECT_EQ(svg.find('\xFF'), std::string::npos);
  EXPECT_NE(svg.find("\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD ü≈\xF0\x9F\x98\x80"),
            std::string::npos);
}

TEST(PictureSvg, RefusesWhatItCannotDraw) {
  const auto refusal = [](auto change) -> std::string {
    PlanarPicture picture = ring_and_disc();
    change(picture);
    try {
      svg_of(picture);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([](PlanarPicture&) {}), "accepted");
  EXPECT_EQ(refusal([&](PlanarPicture& p) { p.points[0].at.y = nan; }),
            "picture: point 0 has a coordinate that is not finite or beyond 1e150");
  EXPECT_EQ(refusal([&](PlanarPicture& p) { p.faces[1].rings[0].start.x = nan; }),
            "picture: face 1 has a coordinate that is not finite or beyond 1e150");
  EXPECT_EQ(refusal([](PlanarPicture& p) { p.edges[1].path.steps[0].sweep = 1e3; }),
            "picture: edge 1 has an arc without radius or of more than a full turn");
  EXPECT_THROW(svg_of(ring_and_disc(), {.size = 0}), InputError);
}

TEST(PictureSvg, OfNothingIsASheet) {
  expect_well_formed(svg_of({}));
  PlanarPicture one;
  one.points.push_back({{1e12, -7}, 1, {}, {}});
  const std::string svg = svg_of(one, {.size = 100});
  EXPECT_NE(svg.find("cx=\"50\" cy=\"50\""), std::string::npos) << svg;
}

TEST(PicturePath, PartsBetweenTwoVerticalLines) {
  const PicturePath half{{-2, 0}, {arc_to({2, 0}, {0, 0}, -std::numbers::pi)}};
  const PicturePath part = between_x(half, -1, 1);
  ASSERT_EQ(part.steps.size(), 1U);
  EXPECT_NEAR(part.start.y, std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(part.end().y, std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(part.steps[0].sweep, -std::numbers::pi / 3, 1e-12);
  const PicturePath chain = path_of({{0, 0}, {1, 5}, {1, 7}, {3, 9}});
  const PicturePath cut = between_x(chain, 0.5, 2);
  EXPECT_EQ(cut.start, (Point2{0.5, 2.5}));
  EXPECT_EQ(cut.end(), (Point2{2, 8}));
  EXPECT_EQ(cut.steps.size(), 3U);
  EXPECT_TRUE(between_x(chain, 4, 5).steps.empty());
  const PicturePath ring = ring_between(between_x(chain, 0.5, 2), path_of({{0.5, 10}, {2, 10}}));
  EXPECT_EQ(ring.end(), ring.start);
  EXPECT_EQ(ring.steps.size(), 6U);
}

TEST(PicturePath, ReversedTwiceIsThePathAndBoxesHoldArcs) {
  const PicturePath half{{-2, 0}, {arc_to({2, 0}, {0, 0}, -std::numbers::pi), line_to({5, -1})}};
  const PicturePath twice = reversed(reversed(half));
  EXPECT_EQ(twice.start, half.start);
  ASSERT_EQ(twice.steps.size(), 2U);
  EXPECT_EQ(twice.steps[0].sweep, half.steps[0].sweep);
  EXPECT_EQ(twice.steps[1].to, half.steps[1].to);
  PictureBox box;
  add_to(box, half);
  EXPECT_EQ(box.low, (Point2{-2, -1}));
  EXPECT_NEAR(box.high.y, 2, 1e-12);
  for (const Point2& p : flattened(half, 1e-3)) {
    if (p.x <= 2) {
      EXPECT_NEAR(std::hypot(p.x, p.y), 2, 1e-12);
    }
  }
}

TEST(PictureLabels, DoNotCoverEachOther) {
  PlanarPicture picture;
  for (int i = 0; i < 400; ++i) {
    const double x = i % 20;
    const double y = static_cast<double>(i / 20) + 0.05 * x;
    picture.points.push_back({{x, y}, 1, {}, {"", "point " + std::to_string(i), {}}});
  }
  const PictureFrame frame(shown_box(picture), 900, 0);
  const std::vector<PlacedLabel> labels = place_labels(picture, frame);
  EXPECT_GT(labels.size(), 50U);
  const auto half_width = [&](const PlacedLabel& l) {
    return l.size * text_width(picture.points[l.anchor.cell].text.label) / 2;
  };
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool is_apart =
          std::fabs(labels[i].at.x - labels[j].at.x) >= half_width(labels[i]) + half_width(labels[j]) ||
          std::fabs(labels[i].at.y - labels[j].at.y) >= labels[i].size;
      EXPECT_TRUE(is_apart) << i << " " << j;
    }
  }
}

}  // namespace
}  // namespace quoin
