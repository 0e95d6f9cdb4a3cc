// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "quoin/io/test_drawings.h"
#include "quoin/number/rational.h"

namespace quoin {
namespace {

using testing::context;
using testing::error_of;

Drawing svg(const std::string& text, bool closed_paths_are_polygons = true) {
  return read_drawing(text, "a.svg", {.format = {}, .closed_paths_are_polygons = closed_paths_are_polygons}, context);
}

Drawing document(const std::string& elements) {
  return svg(
      "<?xml version='1.0'?>\n<!DOCTYPE svg PUBLIC \"a>b\" [<!ENTITY x \"y\">]>\n<!-- <path d='C'/> -->\n"
      "<svg xmlns='http://www.w3.org/2000/svg'>" +
      elements + "</svg>\n");
}

std::string refusal(const std::string& text) {
  return error_of([&] { (void)svg(text); });
}

DrawingPath path(std::vector<Point2> points, std::vector<double> bulges = {}, bool is_closed = false) {
  return {std::move(points), std::move(bulges), is_closed};
}

TEST(SvgDrawing, PathData) {
  const auto first = [](const std::string& data) {
    return std::get<DrawingPath>(svg(data, false).elements.at(0).shape);
  };
  EXPECT_EQ(first("M0 0L1 0 1 1"), path({{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_EQ(first("M.5.5-1-1"), path({{.5, .5}, {-1, -1}}));
  EXPECT_EQ(first("m1,2 3,4h-1v+1H9V-1e1"), path({{1, 2}, {4, 6}, {3, 6}, {3, 7}, {9, 7}, {9, -10}}));
  EXPECT_EQ(first("M0 0H4V4Z"), path({{0, 0}, {4, 0}, {4, 4}}, {}, true));
  EXPECT_EQ(first("M0 0H4V4L0 0z"), path({{0, 0}, {4, 0}, {4, 4}}, {}, true));
  EXPECT_EQ(first("M0 0H4V4L0 0"), path({{0, 0}, {4, 0}, {4, 4}, {0, 0}}));
  EXPECT_EQ(first("M1 0A1 1 0 01-1 0"), path({{1, 0}, {-1, 0}}, {1}));
  EXPECT_EQ(first("M1 0a1 1 99 1 0-2 0z"), path({{1, 0}, {-1, 0}}, {-1, 0}, true));
  EXPECT_EQ(first("M3-4A5 5 0 0 1 3 4"), path({{3, -4}, {3, 4}}, {0.5}));
  EXPECT_EQ(first("M3-4A5 5 0 1 0 3 4"), path({{3, -4}, {3, 4}}, {-2}));
  EXPECT_EQ(first("M0 0A1 1 0 0 1 0 0L1 1"), path({{0, 0}, {0, 0}, {1, 1}}));
}

TEST(SvgDrawing, SubpathsAfterZBeginWhereTheOneBeforeBegan) {
  const Drawing drawing = svg("M1 1h1v1zl5 5M7 7h1v1z", false);
  ASSERT_EQ(drawing.elements.size(), 3U);
  EXPECT_EQ(drawing.elements[1].shape, decltype(DrawingElement::shape)(path({{1, 1}, {6, 6}})));
  EXPECT_EQ(drawing.elements[1].name, "path 1, subpath 2");
  const Drawing polygons = svg("M1 1h1v1zl5 5M7 7h1v1z");
  ASSERT_EQ(polygons.elements.size(), 2U);
  const auto& polygon = std::get<DrawingPolygon>(polygons.elements[0].shape);
  EXPECT_EQ(polygon.rings.size(), 2U);
  EXPECT_EQ(polygon.fill, FillRule::nonzero);
}

TEST(SvgDrawing, RelativeSumsAreExactBeforeTheyAreRounded) {
  const Drawing drawing = svg("m0.1 0.1 0.2 0 0.3 0 -0.6 0");
  const auto& points = std::get<DrawingPath>(drawing.elements.at(0).shape).points;
  EXPECT_EQ(points[1].x, 0.1 + 0.2);
  EXPECT_NEAR(points[3].x, (Rational(0.1) + Rational(0.2) + Rational(0.3) - Rational(0.6)).to_double(), 0);
  ASSERT_EQ(drawing.notes.size(), 1U);
  EXPECT_EQ(drawing.notes[0].substr(0, 60), "sums of relative coordinates are rounded: 2 (first path 1), ");
  EXPECT_TRUE(svg("m0.5 0.5 0.25 0 1e6 0").notes.empty());
}

TEST(SvgDrawing, RadiiAreAdjustedWithNotes) {
  const Drawing drawing = svg("M0 0A0.75 0.75 0 0 1 2 0");
  EXPECT_EQ(std::get<DrawingPath>(drawing.elements.at(0).shape), path({{0, 0}, {2, 0}}, {1}));
  EXPECT_EQ(drawing.notes, std::vector<std::string>{"radii of arcs are adjusted: 1 (path 1), by at most 0.253"});
  EXPECT_EQ(svg("M0 0A0 0 0 0 1 2 0").notes, std::vector<std::string>{"arcs of radius zero are straight: 1 (path 1)"});
}

TEST(SvgDrawing, Shapes) {
  const Drawing drawing = document(
      "<line x1='1' y1='2' x2='3px' y2='4'/><polyline points='0,0 1,0,1,1'/><polygon points='0 0 1 0 1 1' "
      "fill-rule='evenodd'/><rect x='1' y='2' width='3' height='4'/><circle cx='1' cy='2' r='3'/><ellipse rx='2' "
      "ry='2'/><rect width='4' height='2' rx='1'/><text>M</text><text/><title>t</title><defs><path d='C'/></defs>"
      "<path id='&lt;a&gt;' d='M0 0L1 1'/>");
  ASSERT_EQ(drawing.elements.size(), 8U);
  EXPECT_EQ(std::get<DrawingPath>(drawing.elements[0].shape), path({{1, 2}, {3, 4}}));
  EXPECT_EQ(std::get<DrawingPath>(drawing.elements[1].shape), path({{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_EQ(std::get<DrawingPolygon>(drawing.elements[2].shape),
            (DrawingPolygon{{path({{0, 0}, {1, 0}, {1, 1}}, {}, true)}, FillRule::even_odd}));
  EXPECT_EQ(std::get<DrawingPolygon>(drawing.elements[3].shape).rings[0],
            path({{1, 2}, {4, 2}, {4, 6}, {1, 6}}, {}, true));
  EXPECT_EQ(std::get<DrawingCircle>(drawing.elements[4].shape), (DrawingCircle{{1, 2}, 3}));
  EXPECT_EQ(std::get<DrawingCircle>(drawing.elements[5].shape), (DrawingCircle{{0, 0}, 2}));
  const DrawingPath& rounded = std::get<DrawingPolygon>(drawing.elements[6].shape).rings[0];
  EXPECT_EQ(rounded.points, (std::vector<Point2>{{1, 0}, {3, 0}, {4, 1}, {3, 2}, {1, 2}, {0, 1}}));
  EXPECT_GT(rounded.bulge(1), 0);
  EXPECT_EQ(rounded.bulge(3), 0);
  EXPECT_EQ(drawing.elements[6].name, "rect 2");
  EXPECT_EQ(drawing.elements[7].name, "path 1 '<a>'");
  EXPECT_EQ(drawing.notes[2], "elements 'text' are not read: 2");
  EXPECT_EQ(drawing.notes[3], "elements 'defs' are not read: 1");
}

TEST(SvgDrawing, Transforms) {
  const Drawing drawing = document(
      "<g transform='translate(1, 2) scale(2)' fill-rule='evenodd'><path transform='matrix(1 0 0 -1 0 8)' "
      "d='M1 0A1 1 0 0 1 -1 0Z'/><circle r='3' cx='1'/></g><path d='M0 0L1 1'/>");
  EXPECT_EQ(std::get<DrawingPolygon>(drawing.elements.at(0).shape),
            (DrawingPolygon{{path({{3, 18}, {-1, 18}}, {-1, 0}, true)}, FillRule::even_odd}));
  EXPECT_EQ(std::get<DrawingCircle>(drawing.elements.at(1).shape), (DrawingCircle{{3, 2}, 6}));
  EXPECT_EQ(std::get<DrawingPath>(drawing.elements.at(2).shape), path({{0, 0}, {1, 1}}));
  EXPECT_TRUE(drawing.notes.empty());
  const Drawing rounded = document("<g transform='translate(0.1)'><path d='M0.2 0L1 1'/></g>");
  EXPECT_EQ(rounded.notes.at(0).substr(0, 41), "transformed points are rounded: 2 (first ");
}

TEST(SvgDrawing, Layers) {
  const Drawing drawing =
      document("<g inkscape:groupmode='layer' inkscape:label='A &amp; B'><g><line x2='1'/></g></g><line x2='1'/>");
  EXPECT_EQ(drawing.elements.at(0).layer, "A & B");
  EXPECT_EQ(drawing.elements.at(1).layer, "");
}

TEST(SvgDrawing, RefusalsNameLineAndElement) {
  EXPECT_EQ(refusal("M0 0\nC1 1 2 2 3 3"), "a.svg:2: path 1: command 'C': curves are not supported");
  EXPECT_EQ(refusal("M0 0 t1 1"), "a.svg:1: path 1: command 't': curves are not supported");
  EXPECT_EQ(refusal("M0 0A1 2 0 0 1 1 1"), "a.svg:1: path 1: command 'A': elliptical arcs are not supported");
  EXPECT_EQ(refusal("M0 0A1 1 0 2 1 1 1"), "a.svg:1: path 1: an arc's flag is 0 or 1, not '2'");
  EXPECT_EQ(refusal("M0 0L1"), "a.svg:1: path 1: a number should stand here, and the end of the text does");
  EXPECT_EQ(refusal("M0 0L1e999 1"), "a.svg:1: path 1: '1e999' is beyond the largest double");
  EXPECT_EQ(refusal("m1e308 0 1e308 0"), "a.svg:1: path 1: a relative coordinate leads beyond the largest double");
  EXPECT_EQ(refusal("L0 0"), "a.svg:1: path 1: path data begins with M");
  EXPECT_EQ(refusal("M0 0Z1 1"), "a.svg:1: path 1: a command should stand here, and '1' does");
  EXPECT_EQ(refusal("M0 0 X"), "a.svg:1: path 1: 'X' is no command of path data");
  EXPECT_EQ(refusal("<svg>\n<path/>\n<path d='M0 0\nQ'/></svg>"),
            "a.svg:4: path 2: command 'Q': curves are not supported");
  EXPECT_EQ(refusal("<svg><g>\n</svg>"), "a.svg:2: </svg> closes no element; 'g' is open");
  EXPECT_EQ(refusal("<svg><g>"), "a.svg:1: the element 'g' does not end");
  EXPECT_EQ(refusal("<svg/><svg/>"), "a.svg:1: one 'svg' element should stand here");
  EXPECT_EQ(refusal("<html/>"), "a.svg:1: one 'svg' element should stand here");
  EXPECT_EQ(refusal("<!-- "), "a.svg:1: a comment does not end");
  EXPECT_EQ(refusal("<svg><path d='M0 0"), "a.svg:1: the attribute 'd' does not end");
  EXPECT_EQ(refusal("<svg><path d='M0 0' d='M1 1'/></svg>"), "a.svg:1: the attribute 'd' is there twice");
  EXPECT_EQ(refusal("<svg><g transform='rotate(45)'/></svg>"), "a.svg:1: g 1: the transform 'rotate' is not supported");
  EXPECT_EQ(refusal("<svg><g id='k' transform='scale(3)'/></svg>"),
            "a.svg:1: g 1 'k': the transform 'scale' is not supported but for scales by a power of two, equal in x and "
            "y but for the sign");
  EXPECT_EQ(refusal("<svg><ellipse rx='1' ry='2'/></svg>"), "a.svg:1: ellipse 1: ellipses are not supported");
  EXPECT_EQ(refusal("<svg><circle r='1mm'/></svg>"), "a.svg:1: circle 1: '1mm' for 'r' is no number of user units");
  EXPECT_EQ(refusal("<svg><path style='transform: rotate(4deg)' d='M0 0'/></svg>"),
            "a.svg:1: path 1: a transform in a style is not supported");
  EXPECT_EQ(refusal("<svg><svg/></svg>"), "a.svg:1: svg 2: nested svg elements are not supported");
  EXPECT_EQ(refusal("<svg><polygon points='1 2 3'/></svg>"),
            "a.svg:1: polygon 1: a number should stand here, and the end of the text does");
}

TEST(SvgDrawing, DeepNestingIsRefused) {
  std::string text = "<svg>";
  for (int i = 0; i < 100'000; ++i) text += "<g transform='translate(1e-300) scale(5e-324)'>";
  EXPECT_NE(refusal(text).find("its transforms together scale too far"), std::string::npos);
  text = "<svg>";
  for (int i = 0; i < 100'000; ++i) text += "<g>";
  EXPECT_NE(refusal(text).find("elements are nested too deeply"), std::string::npos);
}

TEST(SvgDrawing, HalfCirclesComeBackExactly) {
  Drawing drawing;
  drawing.elements.push_back({path({{0.1, 0.2}, {0.7, 1.1}, {0.3, 5}}, {1, -1}), "p", ""});
  std::vector<std::string> notes;
  const std::string text = testing::written(DrawingFormat::svg, drawing, notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_TRUE(testing::shapes_equal(svg(text), drawing));
}

}  // namespace
}  // namespace quoin
