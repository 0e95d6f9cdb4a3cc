// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "quoin/io/test_drawings.h"

namespace quoin {
namespace {

using testing::context;
using testing::error_of;

Drawing wkt(const std::string& text) {
  return read_drawing(text, "a.wkt", {}, context);
}

std::string refusal(const std::string& text) {
  return error_of([&] { (void)wkt(text); });
}

template <class Shape>
Shape only(const Drawing& drawing) {
  EXPECT_EQ(drawing.elements.size(), 1U);
  return std::get<Shape>(drawing.elements.at(0).shape);
}

TEST(Wkt, SimpleGeometries) {
  EXPECT_EQ(only<Point2>(wkt("POINT (1 -2.5e1)")), (Point2{1, -25}));
  EXPECT_EQ(only<DrawingPath>(wkt("linestring(0 0,1 0, 1 1)")), (DrawingPath{{{0, 0}, {1, 0}, {1, 1}}, {}, false}));
  EXPECT_EQ(only<DrawingPath>(wkt("LINESTRING(0 0,1 0,1 1,0 0)")), (DrawingPath{{{0, 0}, {1, 0}, {1, 1}}, {}, true}));
  const auto polygon = only<DrawingPolygon>(wkt("POLYGON((0 0,9 0,9 9,0 0),(5 2,6 2,6 3,5 2))"));
  ASSERT_EQ(polygon.rings.size(), 2U);
  EXPECT_EQ(polygon.rings[1], (DrawingPath{{{5, 2}, {6, 2}, {6, 3}}, {}, true}));
}

TEST(Wkt, SeveralGeometriesAreNamed) {
  const Drawing drawing =
      wkt("SRID=4326;POINT(1 2);\nMULTIPOINT((1 2),3 4, EMPTY)\n POLYGON EMPTY; MULTILINESTRING((0 0,1 1),(2 2,3 3))"
          "GEOMETRYCOLLECTION(POINT(0 0),GEOMETRYCOLLECTION(MULTIPOLYGON(((0 0,1 0,1 1,0 0)))))");
  std::vector<std::string> names;
  for (const DrawingElement& element : drawing.elements) names.push_back(element.name);
  EXPECT_EQ(names, (std::vector<std::string>{"point 1", "multipoint 2, point 1", "multipoint 2, point 2",
                                             "multilinestring 4, linestring 1", "multilinestring 4, linestring 2",
                                             "collection 5, point 1",
                                             "collection 5, collection 2, multipolygon 1, polygon 1"}));
  EXPECT_EQ(drawing.notes, (std::vector<std::string>{"reference systems (SRID) are not kept: 1 (geometry 1)",
                                                     "empty geometries add nothing: 2 (first multipoint 2, point 3)"}));
}

TEST(Wkt, HeightsAndMeasuresAreNoted) {
  for (const char* text :
       {"POINT Z (1 2 3)", "POINTZ(1 2 3)", "POINT M (1 2 3)", "point zm(1 2 3 4)", "POINT(1 2 3)", "POINT(1 2 3 4)"}) {
    const Drawing drawing = wkt(text);
    EXPECT_EQ(only<Point2>(drawing), (Point2{1, 2})) << text;
    EXPECT_EQ(drawing.notes, std::vector<std::string>{"vertices lose their Z or M: 1 (point 1)"}) << text;
  }
  EXPECT_EQ(refusal("LINESTRING Z(1 2 3, 4 5)"), "a.wkt:1: linestring 1: a vertex of 2 numbers among those of 3");
}

TEST(Wkt, Curves) {
  const Drawing half = wkt("CIRCULARSTRING(1 0, 0 1, -1 0)");
  EXPECT_EQ(only<DrawingPath>(half), (DrawingPath{{{1, 0}, {-1, 0}}, {1}, false}));
  EXPECT_TRUE(half.notes.empty());
  EXPECT_EQ(only<DrawingCircle>(wkt("CIRCULARSTRING(0 1, 4 1, 0 1)")), (DrawingCircle{{2, 1}, 2}));
  const Drawing tilted = wkt("CIRCULARSTRING(0 0, 1 1, 0 0)");  // its radius is no double, its half circles are exact
  EXPECT_EQ(only<DrawingPath>(tilted), (DrawingPath{{{0, 0}, {1, 1}}, {1, 1}, true}));
  EXPECT_TRUE(tilted.notes.empty());
  const auto polygon = only<DrawingPolygon>(
      wkt("CURVEPOLYGON(COMPOUNDCURVE((0 0,4 0),CIRCULARSTRING(4 0,5 1,4 2),(4 2,0 2,0 0)),CIRCULARSTRING(1 1,2 1,1 1),"
          "(3 1, 3 0.5, 3.5 1, 3 1))"));
  ASSERT_EQ(polygon.rings.size(), 3U);
  EXPECT_EQ(polygon.rings[0], (DrawingPath{{{0, 0}, {4, 0}, {4, 2}, {0, 2}}, {0, 1, 0, 0}, true}));
  EXPECT_EQ(polygon.rings[1], (DrawingPath{{{1, 1}, {2, 1}}, {1, 1}, true}));
  const Drawing rounded = wkt("CIRCULARSTRING(1 0, 0.8 0.6, 0 1)");
  EXPECT_DOUBLE_EQ(only<DrawingPath>(rounded).bulges[0], 0.41421356237309503);
  ASSERT_EQ(rounded.notes.size(), 1U);
  EXPECT_EQ(rounded.notes[0].substr(0, 56), "arcs are rounded: 1 (circularstring 1), by at most 6.17e");
  EXPECT_EQ(wkt("MULTICURVE((0 0,1 1),CIRCULARSTRING(1 0,0 1,-1 0))").elements[1].name,
            "multicurve 1, circularstring 2");
  EXPECT_EQ(wkt("MULTISURFACE(((0 0,1 0,1 1,0 0)),CURVEPOLYGON((0 0,1 0,1 1,0 0)))").elements.size(), 2U);
}

TEST(Wkt, RefusalsNameLineAndElement) {
  EXPECT_EQ(refusal("POINT(1 1)\nPOLYGON((0 0,1 0,\n1 1,0 1))"),
            "a.wkt:2: polygon 2, ring 1: the ring is not closed: its last vertex is not its first");
  EXPECT_EQ(refusal("POLYGON((0 0,1 0,0 0))"), "a.wkt:1: polygon 1, ring 1: the ring has too few vertices");
  EXPECT_EQ(refusal("POLYGON((0 0,1 0,1 1,0 0),(0 0))"), "a.wkt:1: polygon 1, ring 2: the ring has too few vertices");
  EXPECT_EQ(refusal("LINESTRING(0 0)"), "a.wkt:1: linestring 1: a curve has at least two vertices");
  EXPECT_EQ(refusal("POINT(1 1e999)"), "a.wkt:1: point 1: '1e999' is beyond the largest double");
  EXPECT_EQ(refusal("POINT(1\nnan)"), "a.wkt:2: point 1: a number should stand here, and 'nan' does");
  EXPECT_EQ(refusal("POINT(inf 1)"), "a.wkt:1: point 1: a number should stand here, and 'inf' does");
  EXPECT_EQ(refusal("POINT(1 1"), "a.wkt:1: point 1: ',' or ')' should stand here, and the end of the text does");
  EXPECT_EQ(refusal("POINT(1 1) junk"), "a.wkt:1: geometry 2: 'junk' is no geometry that is read");
  EXPECT_EQ(refusal("POINT(1 1))"), "a.wkt:1: geometry 2: ')' is no geometry that is read");
  EXPECT_EQ(refusal("TRIANGLE((0 0,1 0,1 1,0 0))"), "a.wkt:1: geometry 1: 'TRIANGLE' is no geometry that is read");
  EXPECT_EQ(refusal("POLYGON(0 0,1 0)"), "a.wkt:1: polygon 1, ring 1: '(' should stand here, and '0' does");
  EXPECT_EQ(refusal("CIRCULARSTRING(0 0,1 1)"),
            "a.wkt:1: circularstring 1: arcs need an odd number of vertices, at least three");
  EXPECT_EQ(refusal("CIRCULARSTRING(0 0,2 2,1 1)"),
            "a.wkt:1: circularstring 1: no arc goes through three of its vertices");
  EXPECT_EQ(refusal("COMPOUNDCURVE((0 0,1 1),(2 2,3 3))"),
            "a.wkt:1: compoundcurve 1, part 2: it does not begin where the part before it ends");
  EXPECT_EQ(refusal(" \n "), "a.wkt:2: there is no geometry");
}

TEST(Wkt, DeepNestingIsRefused) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "GEOMETRYCOLLECTION(";
  EXPECT_NE(refusal(text).find("collections are nested too deeply"), std::string::npos);
}

TEST(Wkt, WritesWhatOthersRead) {
  Drawing drawing;
  drawing.elements.push_back({DrawingCircle{{2, 1}, 2}, "c", ""});
  drawing.elements.push_back({DrawingPath{{{0, 0}, {4, 0}, {4, 2}}, {0, 1}, false}, "p", ""});
  drawing.elements.push_back(
      {DrawingPolygon{{DrawingPath{{{0, 0}, {1, 0}}, {1, 0}, true}}, FillRule::even_odd}, "q", ""});
  drawing.elements.push_back({DrawingPath{{{1, 0}, {-1, 0}}, {1}, false}, "a", ""});
  std::vector<std::string> notes;
  EXPECT_EQ(testing::written(DrawingFormat::wkt, drawing, notes),
            "CIRCULARSTRING (0 1, 4 1, 0 1)\n"
            "COMPOUNDCURVE ((0 0, 4 0), CIRCULARSTRING (4 0, 5 1, 4 2))\n"
            "CURVEPOLYGON (COMPOUNDCURVE (CIRCULARSTRING (0 0, 0.5 -0.5, 1 0), (1 0, 0 0)))\n"
            "CIRCULARSTRING (1 0, 0 1, -1 0)\n");
  EXPECT_TRUE(notes.empty());
}

Drawing drawing_of(std::vector<DrawingElement> elements) {
  return {std::move(elements), {}};
}

std::string as_one(const Drawing& drawing) {
  std::vector<std::string> notes;
  DrawingWriteOptions options;
  options.as_one_geometry = true;
  return testing::written(DrawingFormat::wkt, drawing, notes, options);
}

TEST(Wkt, OneGeometry) {
  const DrawingElement point{Point2{1, 2}, "p", ""};
  const DrawingElement line{DrawingPath{{{0, 0}, {4, 0}}, {}, false}, "l", ""};
  const DrawingElement arc{DrawingPath{{{1, 0}, {-1, 0}}, {1}, false}, "a", ""};
  const DrawingElement circle{DrawingCircle{{2, 1}, 2}, "c", ""};
  const DrawingElement triangle{DrawingPolygon{{DrawingPath{{{0, 0}, {1, 0}, {1, 1}}, {}, true}}, FillRule::even_odd},
                                "t", ""};
  const DrawingElement disc{DrawingPolygon{{DrawingPath{{{0, 0}, {1, 0}}, {1, 1}, true}}, FillRule::even_odd}, "d", ""};
  EXPECT_EQ(as_one({}), "POLYGON EMPTY\n");
  EXPECT_EQ(as_one(drawing_of({triangle})), "POLYGON ((0 0, 1 0, 1 1, 0 0))\n");
  EXPECT_EQ(as_one(drawing_of({circle})), "CIRCULARSTRING (0 1, 4 1, 0 1)\n");
  EXPECT_EQ(as_one(drawing_of({triangle, triangle})),
            "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)), ((0 0, 1 0, 1 1, 0 0)))\n");
  EXPECT_EQ(
      as_one(drawing_of({triangle, disc})),
      "MULTISURFACE (((0 0, 1 0, 1 1, 0 0)), CURVEPOLYGON (CIRCULARSTRING (0 0, 0.5 -0.5, 1 0, 0.5 0.5, 0 0)))\n");
  EXPECT_EQ(as_one(drawing_of({line, line})), "MULTILINESTRING ((0 0, 4 0), (0 0, 4 0))\n");
  EXPECT_EQ(as_one(drawing_of({line, arc, circle})),
            "MULTICURVE ((0 0, 4 0), CIRCULARSTRING (1 0, 0 1, -1 0), CIRCULARSTRING (0 1, 4 1, 0 1))\n");
  EXPECT_EQ(as_one(drawing_of({point, point})), "MULTIPOINT ((1 2), (1 2))\n");
  EXPECT_EQ(as_one(drawing_of({point, line, triangle})),
            "GEOMETRYCOLLECTION (POINT (1 2), LINESTRING (0 0, 4 0), POLYGON ((0 0, 1 0, 1 1, 0 0)))\n");
}

// As one geometry or one by one, the same shapes come back.
TEST(Wkt, OneGeometryIsReadBack) {
  testing::Random random(11);
  std::size_t compared = 0;
  for (int round = 0; round < 2000; ++round) {
    testing::DrawingFamily family;
    family.has_arcs = round % 2 == 0;
    family.has_points = family.has_circles = family.has_closed_paths = round % 4 < 2;
    const Drawing drawing = testing::random_drawing(random, family);
    std::vector<std::string> notes;
    const std::string one_by_one = testing::written(DrawingFormat::wkt, drawing, notes);
    const std::string text = as_one(drawing);
    ASSERT_EQ(one_by_one.empty(), text.empty()) << round;
    if (text.empty()) continue;
    ASSERT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    ASSERT_TRUE(testing::shapes_equal(wkt(text), wkt(one_by_one))) << text << one_by_one;
    ++compared;
  }
  EXPECT_GT(compared, 1000U);
}

}  // namespace
}  // namespace quoin
